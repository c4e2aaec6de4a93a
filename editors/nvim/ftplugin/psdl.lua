if vim.b.did_ftplugin then
  return
end
vim.b.did_ftplugin = 1

local options = {
  commentstring = '# %s',
  comments = 'b:#,fb:-',
  suffixesadd = '.psdl',
  expandtab = true,
  shiftwidth = 4,
  softtabstop = 4,
  tabstop = 8,
}
for name, value in pairs(options) do
  vim.opt_local[name] = value
end

local undo = {}
for name in pairs(options) do
  undo[#undo + 1] = 'setlocal ' .. name .. '<'
end

if require('psdl.highlight').start(vim.api.nvim_get_current_buf()) then
  vim.opt_local.foldexpr = 'v:lua.vim.treesitter.foldexpr()'
  undo[#undo + 1] = 'setlocal foldexpr<'
  undo[#undo + 1] = 'lua pcall(vim.treesitter.stop)'
end
vim.b.undo_ftplugin = table.concat(undo, ' | ')
