-- Highlighting by the syntax file, where no parser for Python is installed.
local t = require('lib')

local function group(bufnr, text, offset)
  local row, column = t.place(bufnr, text, offset)
  return vim.fn.synIDattr(vim.fn.synID(row + 1, column + 1, 1), 'name')
end

t.test('objects, constants, directions and anchors have groups of their own', function()
  vim.cmd.syntax('enable')
  local bufnr = t.open(t.scene('lamp.psdl') .. '# psdl: ignore overlap\n')
  t.equal(false, require('psdl.highlight').available())
  t.equal('psdl', vim.bo[bufnr].syntax)
  t.equal('psdlConstructor', group(bufnr, 'Object('))
  t.equal('psdlFunction', group(bufnr, 'set_size'))
  t.equal('psdlConstant', group(bufnr, '0.25'))
  t.equal('psdlDirection', group(bufnr, 'Y_MIN'))
  t.equal('psdlSupport', group(bufnr, 'STANDING'))
  t.equal('psdlScene', group(bufnr, 'scene.center'))
  t.equal('psdlAnchor', group(bufnr, '.center.x', 1))
  t.equal('psdlIgnore', group(bufnr, '# psdl: ignore', 3))
  t.equal('pythonString', group(bufnr, '"Lamp"', 2))
  t.equal('pythonRepeat', group(bufnr, 'for i, chair'))
end)

t.test('a body is indented as in Python', function()
  local bufnr = t.open('for i in range(3):\n')
  vim.api.nvim_feedkeys(vim.keycode('Gox = i<Esc>'), 'x', false)
  t.equal('    x = i', t.lines(bufnr)[2])
end)

t.run()
