--- Moving and turning an object: which one, where to, and by which edit of the program.
local request = require('psdl.request')
local M = {}

M.facings = { 'X+', 'Y+', 'X-', 'Y-' }

local axes = { 'x', 'y', 'z' }
local usage = 'write where its center shall be, as in `x=1.2 z=0.5` or `1.2 0 0.5`, or how far it shall go, as in `x+0.3 y-0.1`'

--- Reads where an object shall go, for one whose center is known. A coordinate that is not named stays.
---@param text string
---@param center number[]
---@return (number|vim.NIL)[]?
function M.target(text, center)
  local to = { vim.NIL, vim.NIL, vim.NIL }
  local words = vim.split(vim.trim(text), '[%s,]+')
  if #words == 3 and vim.iter(words):all(tonumber) then
    return vim.tbl_map(tonumber, words)
  end
  for _, word in ipairs(words) do
    local axis, sign, digits = word:lower():match('^([xyz])([=+-])(-?[%d.]+)$')
    local index, value = vim.fn.index(axes, axis or '') + 1, tonumber(digits)
    if index == 0 or not value or to[index] ~= vim.NIL then
      return nil
    end
    to[index] = sign == '=' and value or center[index] + (sign == '-' and -value or value)
  end
  return to
end

--- The objects that a line declares or places, by their place in the layout; all of them, where it does neither.
---@param layout psdl.LayoutResult
---@param line integer from 0
---@return integer[]
function M.objects(layout, line)
  local all, here = {}, {}
  for index, object in ipairs(layout.ranges) do
    all[#all + 1] = index - 1
    for _, range in ipairs({ object.declaration, unpack(object.placements) }) do
      if type(range) == 'table' and range.start.line <= line and line <= range['end'].line then
        here[#here + 1] = index - 1
        break
      end
    end
  end
  return #here > 0 and here or all
end

---@generic T
---@param items T[]
---@param prompt string
---@param format fun(item: T): string
---@param done fun(item: T)
local function pick(items, prompt, format, done)
  if #items == 1 then
    return done(items[1])
  end
  vim.ui.select(items, { prompt = prompt, format_item = format }, function(item)
    if item ~= nil then
      done(item)
    end
  end)
end

--- Finds the object that is meant, and what the layout says of it.
---@param bufnr integer
---@param path? string
---@param done fun(object: psdl.LayoutObject)
local function object(bufnr, path, done)
  local line = vim.api.nvim_win_get_cursor(0)[1] - 1
  request.ask(bufnr, 'psdl/layout', {}, function(result)
    ---@cast result psdl.LayoutResult
    local objects = type(result.layout) == 'table' and result.layout.objects or {}
    local found = path and {} or M.objects(result, line)
    for index, known in ipairs(path and objects or {}) do
      if known.path == path then
        found = { index - 1 }
      end
    end
    if #found == 0 then
      return request.say(path and ('there is no object %s'):format(path) or 'there are no objects', vim.log.levels.ERROR)
    end
    pick(found, 'Which object?', function(index)
      return objects[index + 1].path
    end, function(index)
      done(objects[index + 1])
    end)
  end)
end

--- Asks for edits, lets the user choose where there are several, and applies one.
---@param bufnr integer
---@param method string
---@param params table
---@param done? fun(choice: psdl.Choice)
local function edit(bufnr, method, params, done)
  request.ask(bufnr, method, params, function(result, client)
    ---@cast result { version: integer|vim.NIL, choices: psdl.Choice[] }
    if #result.choices == 0 then
      return request.say('no edit of the program does this', vim.log.levels.WARN)
    end
    pick(result.choices, 'How?', function(choice)
      local errors = ('%d error%s'):format(choice.errors, choice.errors == 1 and '' or 's')
      return ('%s (%s%s)'):format(choice.title, choice.exact and '' or 'not quite there, ', errors)
    end, function(choice)
      if request.apply(bufnr, result.version, choice.edit, client) then
        request.say(choice.title)
        if done then
          done(choice)
        end
      end
    end)
  end)
end

---@param options { bufnr?: integer, object?: string, to?: string }
---@param done? fun(choice: psdl.Choice)
function M.move(options, done)
  local bufnr = options.bufnr or vim.api.nvim_get_current_buf()
  object(bufnr, options.object, function(known)
    local function go(text)
      if not text then
        return
      end
      local to = M.target(text, known.center)
      if not to then
        return request.say(usage, vim.log.levels.ERROR)
      end
      edit(bufnr, 'psdl/move', { object = known.path, to = to }, done)
    end
    if options.to and options.to ~= '' then
      return go(options.to)
    end
    local at = ('x=%.2f y=%.2f z=%.2f'):format(unpack(known.center))
    vim.ui.input({ prompt = ('Move %s (%s) to: '):format(known.path, at) }, go)
  end)
end

---@param options { bufnr?: integer, object?: string, facing?: psdl.Facing }
---@param done? fun(choice: psdl.Choice)
function M.turn(options, done)
  local bufnr = options.bufnr or vim.api.nvim_get_current_buf()
  if options.facing and not vim.list_contains(M.facings, options.facing) then
    return request.say('an object faces one of ' .. table.concat(M.facings, ', '), vim.log.levels.ERROR)
  end
  object(bufnr, options.object, function(known)
    pick(options.facing and { options.facing } or M.facings, ('Turn %s to'):format(known.path), function(facing)
      return facing .. (facing == known.facing and ' (now)' or '')
    end, function(facing)
      edit(bufnr, 'psdl/turn', { object = known.path, facing = facing }, done)
    end)
  end)
end

return M
