-- Highlighting through the tree-sitter parser for Python, with our queries.
local t = require('lib')

local function captures(bufnr, text, offset)
  local row, column = t.place(bufnr, text, offset)
  return vim.tbl_map(function(capture)
    return capture.capture
  end, vim.treesitter.get_captures_at_pos(bufnr, row, column))
end

local function last(bufnr, text, offset)
  local found = captures(bufnr, text, offset)
  return found[#found]
end

t.test('our queries colour a program', function()
  local bufnr = t.open(t.scene('lamp.psdl'))
  t.equal(true, require('psdl.highlight').available())
  local parser = vim.treesitter.get_parser(bufnr)
  t.equal('psdl', parser:lang())
  parser:parse(true)
  t.equal('constructor', last(bufnr, 'Object('))
  t.equal('function.builtin', last(bufnr, 'set_size'))
  t.equal('number.float', last(bufnr, '0.25'))
  t.equal('constant.builtin', last(bufnr, 'Y_MIN'))
  t.equal('variable.builtin', last(bufnr, 'scene.center'))
  t.equal('property', last(bufnr, '.center.x', 1))
  t.equal('variable.parameter', last(bufnr, 'width=4'))
  t.equal('keyword.repeat', last(bufnr, 'for i, chair'))
end)

t.test('all queries are understood by the parser', function()
  for _, name in ipairs({ 'highlights', 'folds', 'locals', 'injections' }) do
    assert(vim.treesitter.query.get('psdl', name), name)
  end
end)

t.test('loops and branches fold', function()
  local bufnr = t.open(t.scene('lamp.psdl'))
  vim.wo.foldmethod = 'expr'
  local row = t.place(bufnr, 'for i, chair')
  t.eventually('folds', function()
    vim.cmd('silent! normal! zx')
    return vim.fn.foldlevel(row + 2) > 0
  end)
end)

t.test('ordinary Python keeps to its own', function()
  t.open(t.scene('lamp.psdl'))
  local path = vim.fs.joinpath(t.folder, 'plain.py')
  vim.fn.writefile({ 'scene = Object()' }, path)
  vim.cmd.edit(path)
  t.equal('python', vim.bo.filetype)
  t.equal('python', vim.treesitter.language.get_lang('python'))
  t.equal(0, #vim.lsp.get_clients({ bufnr = 0 }))
end)

t.run()
