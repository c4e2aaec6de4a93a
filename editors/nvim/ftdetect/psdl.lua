vim.filetype.add({
  extension = { psdl = 'psdl' },
  pattern = { ['.*%.template%.json'] = 'json' },
})
