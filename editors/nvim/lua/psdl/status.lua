--- What stands in a status line.
local M = {}

---@type table<integer, table<string|integer, lsp.WorkDoneProgressBegin>> Work that has begun and not ended, by client and token.
local work = {}

---@param group integer
function M.start(group)
  vim.api.nvim_create_autocmd('LspProgress', {
    group = group,
    desc = 'Note what psdl works on',
    callback = function(event)
      local client = vim.lsp.get_client_by_id(event.data.client_id)
      if not client or client.name ~= 'psdl' then
        return
      end
      local token, value = event.data.params.token, event.data.params.value
      local mine = work[client.id] or {}
      mine[token] = value.kind ~= 'end' and vim.tbl_extend('force', mine[token] or {}, value) or nil
      work[client.id] = mine
      vim.cmd.redrawstatus()
    end,
  })
  vim.api.nvim_create_autocmd('DiagnosticChanged', {
    group = group,
    desc = 'Show the number of errors of psdl',
    callback = function(event)
      if vim.bo[event.buf].filetype == 'psdl' then
        vim.cmd.redrawstatus()
      end
    end,
  })
end

---@param count integer
---@param word string
---@return string?
local function some(count, word)
  return count > 0 and ('%d %s%s'):format(count, word, count == 1 and '' or 's') or nil
end

---@param bufnr? integer
---@return string
function M.text(bufnr)
  bufnr = (bufnr and bufnr ~= 0) and bufnr or vim.api.nvim_get_current_buf()
  local client = vim.lsp.get_clients({ name = 'psdl', bufnr = bufnr })[1]
  if not client then
    return ''
  end
  for _, value in pairs(work[client.id] or {}) do
    local parts = { 'psdl:', value.title }
    if value.message then
      parts[#parts + 1] = value.message
    end
    if value.percentage then
      parts[#parts + 1] = ('%d%%'):format(value.percentage)
    end
    return table.concat(parts, ' ')
  end
  local count = vim.diagnostic.count(bufnr)
  local errors, warnings = count[vim.diagnostic.severity.ERROR] or 0, count[vim.diagnostic.severity.WARN] or 0
  local parts = { some(errors, 'error') or 'no errors' }
  parts[#parts + 1] = some(warnings, 'warning')
  return 'psdl: ' .. table.concat(parts, ', ')
end

return M
