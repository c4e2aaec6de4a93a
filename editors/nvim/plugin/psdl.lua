if vim.g.loaded_psdl then
  return
end
vim.g.loaded_psdl = true

if vim.fn.has('nvim-0.11') == 0 then
  vim.notify('psdl needs Neovim 0.11 or newer', vim.log.levels.ERROR)
  return
end

require('psdl').start()
