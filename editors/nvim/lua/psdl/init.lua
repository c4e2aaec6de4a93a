--- What a user of Neovim sees of psdl: commands, code lenses, inlay hints and a status line over `psdl lsp`.
--- Everything that an editor does for any language (diagnostics, code actions, hover, …) is Neovim's own.
local M = {}

---@type psdl.Options
local defaults = { enable = true, inlay_hints = true, code_lens = true, view = 'both', step = 0.05 }

--- The options that hold: the defaults, `vim.g.psdl`, and what `setup` was given.
---@type psdl.Options
M.options = vim.deepcopy(defaults)

local group = vim.api.nvim_create_augroup('psdl', {})

--- Changes options. Not needed: the plugin starts by itself, with those of `vim.g.psdl`.
---@param options? psdl.Options
function M.setup(options)
  M.options = vim.tbl_extend('force', M.options, options or {})
  vim.lsp.enable('psdl', M.options.enable)
end

---@param client vim.lsp.Client
---@param bufnr integer
local function attach(client, bufnr)
  if M.options.inlay_hints and client:supports_method('textDocument/inlayHint', bufnr) then
    vim.lsp.inlay_hint.enable(true, { bufnr = bufnr })
  end
  if M.options.code_lens and client:supports_method('textDocument/codeLens', bufnr) then
    local function refresh()
      vim.lsp.codelens.refresh({ bufnr = bufnr })
    end
    refresh()
    vim.api.nvim_create_autocmd({ 'BufEnter', 'InsertLeave', 'TextChanged' }, {
      group = group,
      buffer = bufnr,
      callback = refresh,
      desc = 'Ask for the code lenses of psdl',
    })
  end
end

--- Starts everything; called once, by `plugin/psdl.lua`.
function M.start()
  M.setup(vim.g.psdl --[[@as psdl.Options?]])
  vim.api.nvim_create_autocmd('LspAttach', {
    group = group,
    desc = 'Show inlay hints and code lenses of psdl',
    callback = function(event)
      local client = vim.lsp.get_client_by_id(event.data.client_id)
      if client and client.name == 'psdl' then
        attach(client, event.buf)
      end
    end,
  })
  vim.api.nvim_create_autocmd('LspDetach', {
    group = group,
    desc = 'Ask for no more code lenses of psdl',
    callback = function(event)
      local client = vim.lsp.get_client_by_id(event.data.client_id)
      if client and client.name == 'psdl' then
        vim.api.nvim_clear_autocmds({ group = group, buffer = event.buf })
      end
    end,
  })
  require('psdl.status').start(group)
  require('psdl.commands').create()
end

--- A short text for a status line: errors and warnings of a buffer, and what the server works on.
--- Empty in buffers without psdl.
---@param bufnr? integer
---@return string
function M.status(bufnr)
  return require('psdl.status').text(bufnr)
end

--- Corrects the layout errors of a buffer. The callback is told what was done, after it was done.
---@param options? { bufnr?: integer, range?: lsp.Range, kinds?: string[], method?: 'guided'|'paper', max_edits?: integer }
---@param done? fun(result: psdl.FixResult)
function M.fix(options, done)
  require('psdl.actions').fix(options or {}, done)
end

--- Draws the scene of a buffer into a file (`.svg` or `.png`).
---@param options? { bufnr?: integer, path?: string, view?: psdl.View, open?: boolean }
---@param done? fun(path: string, result: psdl.RenderResult)
function M.render(options, done)
  require('psdl.actions').render(options or {}, done)
end

--- Moves an object: that of the path, or of the line of the cursor. `to` is as in |:PsdlMove|; without it, the user is asked.
---@param options? { bufnr?: integer, object?: string, to?: string }
---@param done? fun(choice: psdl.Choice)
function M.move(options, done)
  require('psdl.place').move(options or {}, done)
end

--- Turns an object: that of the path, or of the line of the cursor.
---@param options? { bufnr?: integer, object?: string, facing?: psdl.Facing }
---@param done? fun(choice: psdl.Choice)
function M.turn(options, done)
  require('psdl.place').turn(options or {}, done)
end

--- Opens a window with the constants of a buffer.
---@param bufnr? integer
function M.constants(bufnr)
  require('psdl.constants').open(bufnr)
end

return M
