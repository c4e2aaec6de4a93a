--- Fixing and drawing.
local request = require('psdl.request')
local M = {}

---@param count integer
---@param word string
---@return string
local function many(count, word)
  return ('%d %s%s'):format(count, word, count == 1 and '' or 's')
end

---@param options { bufnr?: integer, range?: lsp.Range, kinds?: string[], method?: 'guided'|'paper', max_edits?: integer }
---@param done? fun(result: psdl.FixResult)
function M.fix(options, done)
  local bufnr = options.bufnr or vim.api.nvim_get_current_buf()
  local params = {
    range = options.range,
    kinds = options.kinds and #options.kinds > 0 and options.kinds or nil,
    method = options.method,
    maxEdits = options.max_edits,
    workDoneToken = 'psdl-fix-' .. vim.uv.hrtime(),
  }
  request.ask(bufnr, 'psdl/fix', params, function(result, client)
    ---@cast result psdl.FixResult
    local errors = ('%d → %d'):format(result.before.errors, result.after.errors)
    if #result.edits == 0 then
      request.say(result.before.errors == 0 and 'nothing to fix' or 'no fix was found; errors: ' .. result.before.errors)
    elseif request.apply(bufnr, result.version, result.edit, client) then
      request.say(('%s, errors %s, %s moved'):format(many(#result.edits, 'edit'), errors, many(result.moved, 'object')))
    else
      return
    end
    if done then
      done(result)
    end
  end)
end

---@param options { bufnr?: integer, path?: string, view?: psdl.View, open?: boolean }
---@param done? fun(path: string, result: psdl.RenderResult)
function M.render(options, done)
  local bufnr = options.bufnr or vim.api.nvim_get_current_buf()
  local settings = require('psdl').options
  local path = options.path
  if not path or path == '' then
    local stem = vim.fn.fnamemodify(vim.api.nvim_buf_get_name(bufnr), ':t:r')
    path = vim.fs.joinpath(vim.fn.stdpath('cache') --[[@as string]], 'psdl', (stem == '' and 'scene' or stem) .. '.svg')
    vim.fn.mkdir(vim.fs.dirname(path), 'p')
  end
  local format = path:match('%.png$') and 'png' or 'svg'
  local params = { format = format, view = options.view or settings.view, theme = settings.theme or vim.o.background }
  request.ask(bufnr, 'psdl/render', params, function(result)
    ---@cast result psdl.RenderResult
    local data = format == 'png' and vim.base64.decode(result.data) or result.data
    local file, why = io.open(path, 'wb')
    if not file then
      return request.say(why or 'the picture could not be written', vim.log.levels.ERROR)
    end
    file:write(data)
    file:close()
    request.say('wrote ' .. path .. (result.stale and ' (of the last text that could be run)' or ''))
    if options.open then
      vim.ui.open(path)
    end
    if done then
      done(path, result)
    end
  end)
end

return M
