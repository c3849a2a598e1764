-- Neovim as a client: opens a graph, waits for its diagnostics, asks for a hover, completes, applies a code action, and
-- writes what the buffer then is. Run by tests/lsp/neovim: nvim --headless -u NONE -l or -S, with EAGERX_GEN, GRAPH, RESULT.
local function fail(what)
  io.stderr:write("FAIL: " .. what .. "\n")
  vim.cmd("cquit 1")
end

local function wait(what, condition)
  if not vim.wait(20000, condition, 20) then
    fail("never: " .. what)
  end
end

vim.cmd("edit " .. vim.env.GRAPH)
local buffer = vim.api.nvim_get_current_buf()
local id = vim.lsp.start_client({ name = "eagerx-gen", cmd = { vim.env.EAGERX_GEN, "lsp" }, root_dir = vim.fn.getcwd() })
vim.lsp.buf_attach_client(buffer, id)

-- The mistake in the file: one letter of an id.
wait("diagnostics", function()
  return #vim.diagnostic.get(buffer, { severity = vim.diagnostic.severity.ERROR }) == 1
end)
local problem = vim.diagnostic.get(buffer)[1]
local word = vim.api.nvim_buf_get_text(buffer, problem.lnum, problem.col, problem.end_lnum, problem.end_col, {})[1]
if word ~= "Pendulm" then
  fail("the diagnostic is at `" .. word .. "`")
end

local function request(method, params)
  local answers = vim.lsp.buf_request_sync(buffer, method, params, 20000)
  local answer = answers and answers[id]
  if not answer or answer.error then
    fail(method .. ": " .. vim.inspect(answers))
  end
  return answer.result
end
local function at(line, column)
  return { textDocument = vim.lsp.util.make_text_document_params(buffer), position = { line = line, character = column } }
end

-- Its help as an edit.
local range = { start = { line = problem.lnum, character = problem.col }, ["end"] = { line = problem.end_lnum, character = problem.end_col } }
local actions = request("textDocument/codeAction",
  { textDocument = vim.lsp.util.make_text_document_params(buffer), range = range, context = { diagnostics = {} } })
if #actions ~= 1 then
  fail("code actions: " .. vim.inspect(actions))
end
local encoding = vim.lsp.get_client_by_id(id).offset_encoding
vim.lsp.util.apply_workspace_edit(actions[1].edit, encoding)
wait("no diagnostics", function()
  return #vim.diagnostic.get(buffer) == 0
end)

-- A key that is begun, completed by Neovim's own function for the key <C-X><C-O>.
local last = vim.api.nvim_buf_line_count(buffer)
vim.api.nvim_buf_set_lines(buffer, last, last, false, { "teleme" })
local completion = request("textDocument/completion", at(last, 6))
local item = (completion.items or completion)[1]
if not item or item.label ~= "telemetry" then
  fail("completion: " .. vim.inspect(completion))
end
vim.lsp.util.apply_text_edits({ item.textEdit }, buffer, encoding)
local hover = request("textDocument/hover", at(last, 2))
if not hover or not hover.contents.value:find("telemetry") then
  fail("hover: " .. vim.inspect(hover))
end

vim.fn.writefile(vim.api.nvim_buf_get_lines(buffer, 0, -1, false), vim.env.RESULT)
vim.lsp.stop_client(id)
wait("the server to end", function()
  return vim.lsp.client_is_stopped(id)
end)
vim.cmd("qall!")
