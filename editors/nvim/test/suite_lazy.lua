-- The plugin under lazy.nvim, which loads it on the type of a file. `init_lazy.lua` is the user's configuration.
local t = require('lib')

local function loaded()
  return require('lazy.core.config').plugins.psdl._.loaded
end

t.test('nothing is loaded before a program is opened', function()
  t.equal(nil, loaded())
  t.equal(nil, vim.g.loaded_psdl)
  t.equal(0, vim.fn.exists(':PsdlFix'))
  t.equal('psdl', vim.filetype.match({ filename = 'a.psdl' }))
end)

t.test('the first program loads it, and gets one server', function()
  local bufnr = t.open(t.scene('lamp.psdl'))
  t.matches('psdl', loaded().ft)
  t.wait_codes(bufnr, { 'standing' })
  t.equal(1, #vim.lsp.get_clients({ name = 'psdl' }))
  t.equal('# %s', vim.bo[bufnr].commentstring)
  t.equal(2, vim.fn.exists(':PsdlFix'))
  t.eventually('hints', function()
    return #vim.lsp.inlay_hint.get({ bufnr = bufnr }) > 0
  end)
end)

t.test('what stands in `opts` holds', function()
  t.equal(false, require('psdl').options.code_lens)
  t.equal(true, require('psdl').options.inlay_hints)
end)

t.test('the second program has the same server', function()
  local bufnr = t.open(t.scene('lamp.psdl'))
  t.wait_codes(bufnr, { 'standing' })
  t.equal(1, #vim.lsp.get_clients({ name = 'psdl' }))
end)

t.test(':checkhealth finds nothing wrong', function()
  t.open(t.scene('lamp.psdl'))
  vim.cmd.checkhealth('psdl')
  local report = table.concat(t.lines(0), '\n')
  t.matches('OK psdl %d+%.%d+%.%d+', report)
  assert(not report:find('ERROR', 1, true), report)
end)

t.run()
