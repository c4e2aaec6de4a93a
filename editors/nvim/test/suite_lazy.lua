-- The plugin when a plugin manager loads it late, on the type of a file, as lazy.nvim does with `ft = 'psdl'`.
local t = require('lib')

t.test('a file that was opened before the plugin was loaded gets its server', function()
  vim.cmd.edit(vim.fs.joinpath(t.folder, 'late.psdl'))
  vim.api.nvim_buf_set_lines(0, 0, -1, false, vim.split(t.scene('lamp.psdl'), '\n'))
  local bufnr = vim.api.nvim_get_current_buf()
  -- As if it had not been loaded: the manager sources the plugin's files and then repeats the event.
  vim.lsp.enable('psdl', false)
  t.eventually('no server', function()
    return #vim.lsp.get_clients({ name = 'psdl' }) == 0
  end)
  vim.g.loaded_psdl = nil
  for name in pairs(package.loaded) do
    if name:match('^psdl') then
      package.loaded[name] = nil
    end
  end
  vim.g.psdl = { code_lens = false }
  vim.cmd.source(vim.fs.joinpath(t.root, 'editors/nvim/plugin/psdl.lua'))
  vim.api.nvim_exec_autocmds('FileType', { buffer = bufnr, modeline = false })
  t.wait_codes(bufnr, { 'standing' })
  t.equal(false, require('psdl').options.code_lens)
  t.equal(true, require('psdl').options.inlay_hints)
end)

t.run()
