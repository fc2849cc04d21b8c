-- What a user of Neovim does with glim --language-server, and what must come
-- of it; run by tests/language/run.
local function ask(method, params)
  local answers = vim.lsp.buf_request_sync(0, method, params, 5000)
  for _, answer in pairs(answers or {}) do return answer.result end
end

local function place(line, column)
  vim.api.nvim_win_set_cursor(0, { line, column })
  return vim.lsp.util.make_position_params()
end

local function diagnosed(count)
  return vim.wait(8000, function() return #vim.diagnostic.get(0) == count end)
end

local function line(number)
  return vim.api.nvim_buf_get_lines(0, number - 1, number, false)[1]
end

local function must(truth, words)
  if not truth then
    print("neovim: not so: " .. words .. "\n" .. vim.inspect(vim.diagnostic.get(0)))
    vim.cmd("cquit")
  end
end

local function all()
  -- The mistake is seen, and mended by its fix.
  must(diagnosed(1), "one mistake")
  local params = place(7, 16)
  params.range = { start = params.position, ["end"] = params.position }
  params.context = { diagnostics = {} }
  local action = ask("textDocument/codeAction", params)[1]
  vim.lsp.util.apply_workspace_edit(action.edit, "utf-16")
  must(line(7) == "sphere { 0, 1 pigment { rgb 1 } }", "the fix applied")
  must(diagnosed(0), "no mistake after it")

  -- Typing: a mistake comes and goes.
  vim.api.nvim_buf_set_lines(0, 7, 7, false, { "box { -1, 1 finish { di } }" })
  must(diagnosed(1), "what is typed is seen")
  local found = false
  for _, item in ipairs(ask("textDocument/completion", place(8, 23)).items) do
    found = found or item.label == "diffuse"
  end
  must(found, "diffuse completes in finish")
  vim.api.nvim_buf_set_lines(0, 7, 8, false, { "box { -1, 1 finish { diffuse Size } }" })
  must(diagnosed(0), "it is right now")

  -- Over the include: hover, definition, rename.
  local hover = ask("textDocument/hover", place(6, 1))
  must(hover.contents.value:find("A ball.", 1, true), "the macro's comment")
  params = place(8, 30)
  params.newName = "Width"
  vim.lsp.util.apply_workspace_edit(ask("textDocument/rename", params), "utf-16")
  must(line(8):find("diffuse Width", 1, true) and line(6) == "Ball(Width)", "renamed here")
  local location -- what was renamed is told to glim a little later
  vim.wait(3000, function()
    location = ask("textDocument/definition", place(8, 30))
    return location
  end)
  vim.lsp.util.jump_to_location(location, "utf-16")
  must(vim.api.nvim_buf_get_name(0):find("part.inc", 1, true), "a jump to the include")
  must(line(3) == "#declare Width = 2;", "renamed there")
  print("neovim is content\n")
  vim.cmd("qall!")
end

local good, problem = pcall(all)
if not good then
  print("neovim: " .. tostring(problem) .. "\n")
  vim.cmd("cquit")
end
