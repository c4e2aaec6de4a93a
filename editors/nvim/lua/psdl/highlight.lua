--- Highlighting through tree-sitter where a Python parser is installed. The parser is loaded a second time under the
--- name `psdl`, so that our queries (`queries/psdl`) never touch buffers that hold ordinary Python.
local M = {}

---@type boolean?
local loaded

--- Whether a Python parser was found and could be loaded.
---@return boolean
function M.available()
  if loaded == nil then
    local path = vim.api.nvim_get_runtime_file('parser/python.*', false)[1]
    loaded = path ~= nil and (pcall(vim.treesitter.language.add, 'psdl', { path = path, symbol_name = 'python' }))
    if loaded then
      -- A parser of another age may not know a node that a query names; then the syntax file serves.
      loaded = pcall(vim.treesitter.query.get, 'psdl', 'highlights')
    end
  end
  return loaded
end

--- Starts it in a buffer; false where it cannot, and the syntax file does the work.
---@param bufnr integer
---@return boolean
function M.start(bufnr)
  return M.available() and (pcall(vim.treesitter.start, bufnr, 'psdl'))
end

return M
