--- Requests that only psdl knows, and what is said when they cannot be made.
local M = {}

--- The version of these requests that this plugin speaks.
M.protocol = 1

--- Errors that say nothing is wrong: the request was cancelled by us, by an edit of the text, or by the server.
local overtaken = { [-32800] = true, [-32801] = true, [-32802] = true }

--- So often an overtaken question is asked again, and so many milliseconds later.
local tries, pause = 5, 50

---@param message string
---@param level? integer
function M.say(message, level)
  vim.notify('psdl: ' .. message, level or vim.log.levels.INFO)
end

--- The client of a buffer, if its server speaks our version; says why not, else.
---@param bufnr integer
---@return vim.lsp.Client?
function M.client(bufnr)
  local client = vim.lsp.get_clients({ name = 'psdl', bufnr = bufnr })[1]
  if not client then
    return M.say('no server runs for this buffer; see :checkhealth psdl', vim.log.levels.ERROR)
  end
  local version = vim.tbl_get(client.server_capabilities, 'experimental', 'psdl', 'version')
  if version ~= M.protocol then
    local found = vim.tbl_get(client.server_info or {}, 'version') or 'of an unknown version'
    local hint = (version or 0) > M.protocol and 'update this plugin' or 'update psdl'
    return M.say(('the server (psdl %s) does not know this; %s'):format(found, hint), vim.log.levels.ERROR)
  end
  return client
end

--- Asks, and hands on what was answered; an error is shown, and nothing is handed on.
---@param bufnr integer
---@param method string
---@param params table What goes beside `textDocument`.
---@param done fun(result: table, client: vim.lsp.Client)
---@param again? fun() What is done where an edit overtook the question; without it the user is told.
function M.ask(bufnr, method, params, done, again)
  local client = M.client(bufnr)
  if not client then
    return
  end
  params = vim.tbl_extend('error', { textDocument = vim.lsp.util.make_text_document_params(bufnr) }, params)
  local tick, left = vim.api.nvim_buf_get_changedtick(bufnr), tries
  local function try()
    ---@diagnostic disable-next-line: param-type-mismatch (methods of our own)
    client:request(method, params, function(err, result)
      if err and overtaken[err.code] then
        local same = vim.api.nvim_buf_is_valid(bufnr) and vim.api.nvim_buf_get_changedtick(bufnr) == tick
        if again then
          vim.defer_fn(again, pause)
        elseif same and left > 0 and not client:is_stopped() then
          -- Not this text has changed, but its template or the configuration.
          left = left - 1
          vim.defer_fn(try, pause)
        else
          M.changed()
        end
      elseif err then
        M.say(err.message, vim.log.levels.ERROR)
      elseif result then
        done(result, client)
      end
    end, bufnr)
  end
  try()
end

--- Says that an answer was for an older text.
function M.changed()
  M.say('the text has changed meanwhile; nothing was done', vim.log.levels.WARN)
end

--- Applies an edit that was made for a version of a buffer; false, and a word to the user, if that has changed since.
---@param bufnr integer
---@param version integer|vim.NIL
---@param edit lsp.WorkspaceEdit
---@param client vim.lsp.Client
---@return boolean
function M.apply(bufnr, version, edit, client)
  if type(version) == 'number' and version ~= vim.lsp.util.buf_versions[bufnr] then
    M.changed()
    return false
  end
  vim.lsp.util.apply_workspace_edit(edit, client.offset_encoding)
  return true
end

return M
