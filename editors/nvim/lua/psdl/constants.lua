--- A window with the constants of a program: what each moves, where it makes no errors, and keys that change it.
local request = require('psdl.request')
local M = {}

---@class psdl.ConstantsView
---@field source integer The buffer with the program.
---@field buffer integer The buffer of the window.
---@field client vim.lsp.Client
---@field constants psdl.Constant[] One a line, from the first line on.

---@type table<integer, psdl.ConstantsView> By the buffer of the window.
local views = {}

local namespace = vim.api.nvim_create_namespace('psdl.constants')

--- A number as Python writes a float: always with a dot, and not longer than it need be.
---@param value number
---@return string
function M.literal(value)
  local text = ('%.6f'):format(value):gsub('0+$', '')
  if text:match('^%-?[0.]+$') and not text:match('[1-9]') then
    return '0.0'
  end
  return text:match('%.$') and text .. '0' or text
end

---@param bound number|vim.NIL
---@param open string
---@return string
local function edge(bound, open)
  return type(bound) == 'number' and ('%.3g'):format(bound) or open
end

---@param constant psdl.Constant
---@return string
local function describe(constant)
  local good = vim.tbl_map(function(interval)
    return ('[%s, %s]'):format(edge(interval[1], '-∞'), edge(interval[2], '∞'))
  end, constant.good)
  local moves = vim.tbl_map(function(move)
    return move.path
  end, constant.moves)
  return ('%5d  %-10s %-12s %-24s %s'):format(
    constant.range.start.line + 1,
    constant.text,
    type(constant.name) == 'string' and constant.name or '',
    table.concat(good, ' '),
    table.concat(vim.list_slice(moves, 1, 4), ' ') .. (#moves > 4 and (' and %d more'):format(#moves - 4) or '')
  )
end

---@param view psdl.ConstantsView
local function draw(view)
  local lines = vim.tbl_map(describe, view.constants)
  if #lines == 0 then
    lines = { 'no constant of this program can be tuned' }
  end
  vim.bo[view.buffer].modifiable = true
  vim.api.nvim_buf_set_lines(view.buffer, 0, -1, false, lines)
  vim.bo[view.buffer].modifiable = false
  vim.bo[view.buffer].modified = false
  vim.api.nvim_buf_clear_namespace(view.buffer, namespace, 0, -1)
  for row, constant in ipairs(view.constants) do
    if constant.errors > 0 then
      vim.api.nvim_buf_set_extmark(view.buffer, namespace, row - 1, 0, {
        line_hl_group = 'DiagnosticError',
        virt_text = { { ('%d error%s'):format(constant.errors, constant.errors == 1 and '' or 's'), 'DiagnosticVirtualTextError' } },
      })
    end
  end
end

---@param view psdl.ConstantsView
local function refresh(view)
  if not (vim.api.nvim_buf_is_valid(view.buffer) and vim.api.nvim_buf_is_loaded(view.source)) then
    return
  end
  request.ask(view.source, 'psdl/constants', {}, function(result, client)
    if vim.api.nvim_buf_is_valid(view.buffer) then
      view.constants, view.client = result.constants, client
      draw(view)
    end
  end, function()
    refresh(view)
  end)
end

---@param view psdl.ConstantsView
---@return psdl.Constant?
local function current(view)
  return view.constants[vim.api.nvim_win_get_cursor(0)[1]]
end

--- Writes a value in the place of a constant.
---@param view psdl.ConstantsView
---@param constant psdl.Constant
---@param value number
local function write(view, constant, value)
  local text = M.literal(value)
  local finish = constant.range['end']
  local line = vim.api.nvim_buf_get_lines(view.source, finish.line, finish.line + 1, false)[1] or ''
  local column = vim.str_byteindex(line, view.client.offset_encoding, finish.character, false)
  if value < 0 and line:sub(column + 1):match('^%s*%*%*') then
    text = '(' .. text .. ')' -- a power binds closer than a sign
  end
  -- An undo of its own: edits of a buffer that is not the current one join, else.
  vim.bo[view.source].undolevels = vim.bo[view.source].undolevels
  vim.lsp.util.apply_text_edits({ { range = constant.range, newText = text } }, view.source, view.client.offset_encoding)
end

--- The number with the fewest decimals near a value that lies between two bounds; the value itself if they are too close.
---@param value number
---@param low number
---@param high number
---@return number
local function short(value, low, high)
  for digits = 0, 6 do
    local rounded = tonumber(('%.' .. digits .. 'f'):format(value)) --[[@as number]]
    if low <= rounded and rounded <= high then
      return rounded
    end
  end
  return value
end

--- The nearest value without errors, a little inside of its interval; nil where there is none, or it stands there.
---@param constant psdl.Constant
---@return number?
function M.nearest(constant)
  local best
  for _, interval in ipairs(constant.good) do
    local low = type(interval[1]) == 'number' and interval[1] or -math.huge
    local high = type(interval[2]) == 'number' and interval[2] or math.huge
    if constant.value >= low and constant.value <= high then
      return nil
    end
    local inset = math.min(0.01, (high - low) / 2)
    local candidate = short(constant.value < low and low + inset or high - inset, low + inset / 2, high - inset / 2)
    if not best or math.abs(candidate - constant.value) < math.abs(best - constant.value) then
      best = candidate
    end
  end
  return best
end

---@param view psdl.ConstantsView
local function map(view)
  local function key(lhs, what, action)
    vim.keymap.set('n', lhs, function()
      local constant = current(view)
      if constant then
        action(constant)
      end
    end, { buffer = view.buffer, desc = what, nowait = true })
  end
  local function nudge(sign)
    return function(constant)
      write(view, constant, constant.value + sign * vim.v.count1 * require('psdl').options.step)
    end
  end
  key('+', 'Make this constant larger', nudge(1))
  key('-', 'Make this constant smaller', nudge(-1))
  key('=', 'Take the nearest value without errors', function(constant)
    local value = M.nearest(constant)
    if value then
      write(view, constant, value)
    else
      request.say('no better value is known')
    end
  end)
  key('<CR>', 'Go to this constant', function(constant)
    local location = { uri = vim.uri_from_bufnr(view.source), range = constant.range }
    local windows = vim.fn.win_findbuf(view.source)
    if windows[1] then
      vim.api.nvim_set_current_win(windows[1])
    end
    vim.lsp.util.show_document(location, view.client.offset_encoding, { reuse_win = true, focus = true })
  end)
  vim.keymap.set('n', 'q', '<Cmd>close<CR>', { buffer = view.buffer, desc = 'Close', nowait = true })
  vim.keymap.set('n', 'u', function()
    vim.api.nvim_buf_call(view.source, vim.cmd.undo)
  end, { buffer = view.buffer, desc = 'Undo in the program', nowait = true })
end

---@param bufnr? integer
function M.open(bufnr)
  bufnr = bufnr or vim.api.nvim_get_current_buf()
  request.ask(bufnr, 'psdl/constants', {}, function(result, client)
    ---@cast result psdl.ConstantsResult
    vim.cmd('botright 12new')
    local buffer = vim.api.nvim_get_current_buf()
    vim.bo[buffer].buftype, vim.bo[buffer].bufhidden, vim.bo[buffer].swapfile = 'nofile', 'wipe', false
    vim.bo[buffer].filetype = 'psdlconstants'
    vim.wo[0].number, vim.wo[0].wrap, vim.wo[0].cursorline = false, false, true
    vim.wo[0].winbar = ' line  value      name         without errors           moves'
    local view = { source = bufnr, buffer = buffer, client = client, constants = result.constants }
    views[buffer] = view
    map(view)
    draw(view)
    local watching = vim.api.nvim_create_autocmd({ 'TextChanged', 'TextChangedI' }, {
      buffer = bufnr,
      desc = 'Show the constants anew',
      callback = function()
        refresh(view)
      end,
    })
    -- Edits from this window come while another buffer is the current one, and raise no TextChanged.
    vim.api.nvim_buf_attach(bufnr, false, {
      on_lines = function()
        if not views[buffer] then
          return true
        end
        vim.schedule(function()
          if vim.api.nvim_get_current_buf() ~= bufnr then
            refresh(view)
          end
        end)
      end,
    })
    vim.api.nvim_create_autocmd('BufWipeout', {
      buffer = buffer,
      once = true,
      callback = function()
        views[buffer] = nil
        pcall(vim.api.nvim_del_autocmd, watching)
      end,
    })
  end)
end

return M
