--- How Neovim starts `psdl lsp`. Change it with `vim.lsp.config('psdl', { … })`; see |psdl-config|.
---@type vim.lsp.Config
return {
  cmd = { 'psdl', 'lsp' },
  filetypes = { 'psdl', 'json', 'toml' },
  root_markers = { 'psdl.toml', '.git' },
  -- Of JSON and TOML, only sidecar templates and the configuration are ours.
  root_dir = function(bufnr, on_dir)
    local name = vim.fs.basename(vim.api.nvim_buf_get_name(bufnr))
    if vim.bo[bufnr].filetype == 'psdl' or name:match('%.template%.json$') or name == 'psdl.toml' then
      on_dir(vim.fs.root(bufnr, vim.lsp.config.psdl.root_markers))
    end
  end,
  workspace_required = false,
  settings = {
    ---@type psdl.Settings
    psdl = {
      inlayHints = { coordinates = true, facings = true, parameters = false, loops = true },
      hover = { picture = false }, -- a hover window of Neovim shows no images
      codeLens = true,
      workspaceDiagnostics = false,
    },
  },
  before_init = function(params, config)
    params.initializationOptions = vim.tbl_get(config, 'settings', 'psdl')
    -- Neovim 0.11 asks for findings only after edits of the very buffer, and of visible ones. The server sends them to a
    -- client that cannot ask, so that an edit of a template shows in its programs at once.
    params.capabilities.textDocument.diagnostic = nil
  end,
}
