-- A user's configuration with lazy.nvim; it asks no network.
vim.opt.runtimepath:prepend(vim.env.LAZY_NVIM)
require('lazy').setup({
  spec = { { name = 'psdl', dir = vim.env.PSDL_TEST_ROOT .. '/editors/nvim', ft = 'psdl', opts = { code_lens = false } } },
  install = { missing = false },
  rocks = { enabled = false },
  checker = { enabled = false },
  change_detection = { enabled = false },
})
