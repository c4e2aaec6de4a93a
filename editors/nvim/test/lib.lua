--- What the suites share: files in a folder of their own, waiting without sleeping, and a count of what held.
local M = { passed = 0, failed = 0, missing = {} }

M.root = vim.env.PSDL_TEST_ROOT
M.folder = vim.env.PSDL_TEST_FOLDER

--- Milliseconds after which nothing is waited for any more; a busy machine may take its time.
local limit = 30000

---@type table[] The tests, in order.
local tests = {}

function M.test(name, body)
  tests[#tests + 1] = { name = name, body = body }
end

--- Lets the editor work until something holds; what it returned then.
function M.eventually(what, condition, milliseconds)
  local value
  local held = vim.wait(milliseconds or limit, function()
    value = condition()
    return value and true or false
  end, 10)
  if not held then
    error('never: ' .. what .. '; last seen ' .. vim.inspect(value), 2)
  end
  return value
end

function M.equal(expected, found, what)
  if not vim.deep_equal(expected, found) then
    error(('%s: expected %s, found %s'):format(what or 'value', vim.inspect(expected), vim.inspect(found)), 2)
  end
end

function M.matches(pattern, text, what)
  if type(text) ~= 'string' or not text:match(pattern) then
    error(('%s: %q does not match %q'):format(what or 'text', tostring(text), pattern), 2)
  end
end

--- The text of a scene of the tests.
function M.scene(name)
  return table.concat(vim.fn.readfile(vim.fs.joinpath(M.root, 'editors/test/scenes', name)), '\n') .. '\n'
end

local count = 0

--- Writes a program to a new file and opens it; its buffer and the client, as soon as its findings are there.
function M.open(text, name)
  count = count + 1
  local path = vim.fs.joinpath(M.folder, name or ('scene%d.psdl'):format(count))
  local file = assert(io.open(path, 'wb'))
  file:write(text)
  file:close()
  vim.cmd.edit(path)
  local bufnr = vim.api.nvim_get_current_buf()
  local client = M.eventually('a server for the buffer', function()
    local found = vim.lsp.get_clients({ name = 'psdl', bufnr = bufnr })[1]
    return found and found.initialized and found
  end)
  return bufnr, client
end

function M.lines(bufnr)
  return vim.api.nvim_buf_get_lines(bufnr, 0, -1, false)
end

function M.codes(bufnr)
  local codes = vim.tbl_map(function(finding)
    return finding.code
  end, vim.diagnostic.get(bufnr))
  table.sort(codes)
  return codes
end

function M.wait_codes(bufnr, expected)
  local held = vim.wait(limit, function()
    return vim.deep_equal(expected, M.codes(bufnr))
  end, 10)
  if not held then
    local name = vim.fs.basename(vim.api.nvim_buf_get_name(bufnr))
    error(('never: findings %s of %s; last seen %s'):format(vim.inspect(expected), name, vim.inspect(M.codes(bufnr))), 2)
  end
end

--- The first line that holds a text, and the column of it, both from 0.
function M.place(bufnr, text, offset)
  for row, line in ipairs(M.lines(bufnr)) do
    local column = line:find(text, 1, true)
    if column then
      return row - 1, column - 1 + (offset or 0)
    end
  end
  error('not in the buffer: ' .. text, 2)
end

function M.cursor(bufnr, text, offset)
  local row, column = M.place(bufnr, text, offset)
  vim.api.nvim_win_set_cursor(0, { row + 1, column })
  return row, column
end

--- Asks the server; its answer.
function M.ask(client, method, params, bufnr)
  local answer, err = client:request_sync(method, params, limit, bufnr)
  if not answer then
    error(method .. ': ' .. tostring(err), 2)
  end
  if answer.err then
    error(method .. ': ' .. answer.err.message, 2)
  end
  return answer.result
end

function M.position(client)
  return vim.lsp.util.make_position_params(0, client.offset_encoding)
end

--- What the plugin says to the user while something is done.
function M.said(body)
  local words, notify = {}, vim.notify
  vim.notify = function(message)
    words[#words + 1] = message
  end
  local done, err = pcall(body, words)
  vim.notify = notify
  if not done then
    error(err, 0)
  end
  return words
end

function M.run()
  for _, test in ipairs(tests) do
    vim.cmd('silent! %bwipeout!')
    local started = vim.uv.hrtime()
    local done, err = xpcall(test.body, function(err)
      return type(err) == 'string' and err or vim.inspect(err)
    end)
    local took = ('%d ms'):format((vim.uv.hrtime() - started) / 1e6)
    if done then
      M.passed = M.passed + 1
      io.stdout:write(('ok - %s (%s)\n'):format(test.name, took))
    else
      M.failed = M.failed + 1
      io.stdout:write(('not ok - %s (%s): %s\n'):format(test.name, took, err))
    end
  end
  io.stdout:write(('%d passed, %d failed\n'):format(M.passed, M.failed))
  io.stdout:flush()
  vim.cmd(M.failed == 0 and 'qall!' or 'cquit 1')
end

return M
