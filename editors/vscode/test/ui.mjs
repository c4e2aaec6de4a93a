// One run through the interface, in the package as users install it: what only pixels, keys and the mouse show.
import assert from "node:assert";
import fs from "node:fs";
import path from "node:path";
import { steps, until, Workbench } from "./workbench.mjs";

const here = import.meta.dirname;
const lamp = fs.readFileSync(path.join(here, "../../test/scenes/lamp.psdl"), "utf8");
const LAMP = "lamp.min.z = table.max.z + ";

/** All that depends on how VS Code builds its pages. */
const at = {
  file: name => `.explorer-folders-view .monaco-list-row:has-text("${name}")`,
  editor: ".monaco-editor .view-lines",
  squiggle: ".monaco-editor .squiggly-error",
  line: text => `.view-line:has-text("${text}")`,
  bulb: "[class*=codicon-light-bulb], [class*=lightbulb]",
  action: text => `.action-widget .monaco-list-row:has-text("${text}")`,
  actions: ".action-widget .monaco-list-row",
  quickInput: ".quick-input-widget input",
  quickTitle: text => `.quick-input-title:has-text("${text}")`,
  quickRow: text => `.quick-input-list .monaco-list-row:has-text("${text}")`,
  status: ".statusbar",
  tab: text => `.tab:has-text("${text}")`,
  position: '.statusbar-item:has-text("Ln ")',
  tree: '.pane:has(.title:has-text("Objects"))',
  row: text => `.monaco-list-row:has-text("${text}")`,
};

const workbench = new Workbench("ui", {
  files: { "lamp.psdl": lamp },
  // Hints are in the text of a line as the page has it; the suite in the extension host tests them.
  settings: { "editor.inlayHints.enabled": "off", "security.workspace.trust.enabled": true, "security.workspace.trust.startupPrompt": "never", "security.workspace.trust.banner": "never" },
});
workbench.install(process.env.VSIX);

let page;
const shot = name => process.env.PSDL_SCREENSHOTS && page.screenshot({ path: path.join(process.env.PSDL_SCREENSHOTS, `${name}.png`) });
const seen = (selector, milliseconds = 60_000) => page.locator(selector).first().waitFor({ state: "visible", timeout: milliseconds });

/** A key that is pressed while the workbench is busy can be lost, or its menu closed at once: do, look, do again. */
async function press(act, selector) {
  for (let attempt = 1; ; attempt++) {
    try {
      await act();
      return await seen(selector, 3000 + 2000 * attempt);
    } catch (error) {
      if (attempt === 8) throw error;
      await page.keyboard.press("Escape");
    }
  }
}

async function command(title) {
  await press(async () => {
    await page.keyboard.press("F1");
    await page.locator(at.quickInput).first().waitFor({ state: "visible", timeout: 5000 });
    await page.locator(at.quickInput).first().fill(`>${title}`);
  }, at.quickRow(title));
  await page.locator(at.quickRow(title)).first().click();
}

/** The text of the line that begins so, as the editor shows it. */
async function lineOf(start) {
  const lines = await page.locator(at.line(start)).allInnerTexts();
  return (lines[0] ?? "").replaceAll("\u00a0", " ").trim();
}

const lampLine = () => lineOf("lamp.min.z");

const lampIs = value => until(`${LAMP}${value}`, async () => (await lampLine()) === LAMP + value);

/** The pages of webviews: the frame whose document holds an element. */
async function webview(selector) {
  return until(`a page with ${selector}`, async () => {
    for (const frame of page.frames()) {
      try {
        if ((await frame.locator(selector).count()) > 0) return frame;
      } catch {
        // it went away meanwhile
      }
    }
    return undefined;
  });
}

/** Goes to a line as a user does. */
async function goTo(text) {
  await press(async () => {
    await page.keyboard.press("Control+g");
    await page.locator(at.quickInput).first().waitFor({ state: "visible", timeout: 5000 });
    const number = lamp.split("\n").findIndex(line => line.startsWith(text)) + 1;
    await page.locator(at.quickInput).first().fill(`:${number}`);
    await page.keyboard.press("Enter");
  }, at.position);
  const number = lamp.split("\n").findIndex(line => line.startsWith(text)) + 1;
  await until(`the cursor in line ${number}`, async () => (await page.locator(at.position).first().innerText()).startsWith(`Ln ${number},`));
}

/** Where the line begins: a line of VS Code is as wide as the longest, and its middle may have to be scrolled to. */
const focusEditor = () => page.locator(at.line("set_title")).first().click({ position: { x: 40, y: 8 } });

const code = await (async () => {
  try {
    return await steps(workbench, [
      [
        "the workbench opens, with the extension from its package",
        async () => {
          await workbench.start();
          page = workbench.page;
          await workbench.open();
          await seen(at.file("lamp.psdl"), 60_000);
        },
      ],
      [
        "in a folder that is not trusted there is highlighting, and no server",
        async () => {
          await press(() => page.locator(at.file("lamp.psdl")).dblclick(), at.editor);
          await until("tokens", async () => (await page.locator('.view-line span[class*="mtk"]').count()) > 3);
          assert.ok((await page.locator(at.status).innerText()).includes("PSDL"));
          assert.equal(await page.locator(at.squiggle).count(), 0);
          await shot("1-untrusted");
        },
      ],
      [
        "trust starts the server, and the error is underlined",
        async () => {
          await command("Workspaces: Manage Workspace Trust");
          await page.locator('.workspace-trust-editor .monaco-button:has-text("Trust")').first().click();
          await seen('.workspace-trust-editor :text("You trust this folder")');
          await shot("2-trust");
          await page.locator(at.tab("lamp.psdl")).first().click();
          await seen(at.squiggle);
          await until("one error in the status bar", async () => /1\s+psdl/.test(await page.locator(at.status).innerText()));
          await shot("2-squiggle");
        },
      ],
      [
        "the light bulb offers a correction, which is applied",
        async () => {
          await focusEditor();
          await goTo("lamp.min.z");
          await seen(at.bulb);
          await press(() => page.keyboard.press("Control+."), at.actions);
          await shot("3-bulb");
          await page.keyboard.press("Enter");
          await until("another number", async () => (await lampLine()) !== `${LAMP}0.25`);
          await until("no squiggle", async () => (await page.locator(at.squiggle).count()) === 0);
          await until("no error in the status bar", async () => !/\d\s+psdl/.test(await page.locator(at.status).innerText()));
        },
      ],
      [
        "undo brings the error back",
        async () => {
          await focusEditor();
          await press(() => page.keyboard.press("Control+z"), at.squiggle);
          await lampIs("0.25");
        },
      ],
      [
        "the command corrects all, and the file is saved",
        async () => {
          await focusEditor();
          await command("PSDL: Correct All Errors");
          await until("no squiggle", async () => (await page.locator(at.squiggle).count()) === 0);
          assert.notEqual(await lampLine(), `${LAMP}0.25`);
          await until("the saved file", async () => {
            await focusEditor();
            await page.keyboard.press("Control+s");
            return !fs.readFileSync(path.join(workbench.files, "lamp.psdl"), "utf8").includes(`${LAMP}0.25`);
          });
          await press(() => page.keyboard.press("Control+z"), at.squiggle);
          await lampIs("0.25");
        },
      ],
      [
        "the picture shows every object",
        async () => {
          await focusEditor();
          await command("PSDL: Show the Scene to the Side");
          const frame = await webview("#picture svg");
          for (const index of [0, 1, 2, 3]) await frame.locator(`g.object[data-object="${index}"]`).first().waitFor({ state: "attached" });
          await shot("4-picture");
        },
      ],
      [
        "the picture follows typing",
        async () => {
          const frame = await webview("#picture svg");
          const before = await frame.locator("#picture").innerHTML();
          await focusEditor();
          await goTo("lamp.min.z");
          await page.keyboard.press("End");
          await page.keyboard.type("1");
          await lampIs("0.251");
          await page.keyboard.press("Backspace");
          await page.keyboard.press("Backspace");
          await page.keyboard.press("Backspace");
          await page.keyboard.type("9");
          await lampIs("0.9");
          await until("another picture", async () => (await frame.locator("#picture").innerHTML()) !== before);
          await shot("5-typing");
        },
      ],
      [
        "a click in the picture selects the line",
        async () => {
          const frame = await webview("#picture svg");
          const number = lamp.split("\n").findLastIndex(line => line.startsWith("table.")) + 1;
          const chosen = () => page.locator(at.position).first().innerText();
          await until("the line of the table", async () => {
            const box = await frame.locator('g.object[data-object="0"] > *:not(title)').first().boundingBox();
            if (box === null) return false; // the picture is just being replaced
            await page.mouse.click(box.x + box.width * 0.15, box.y + box.height * 0.5);
            const end = Date.now() + 1500;
            while (Date.now() < end && !(await chosen()).startsWith(`Ln ${number},`)) await new Promise(resolve => setTimeout(resolve, 50));
            return (await chosen()).startsWith(`Ln ${number},`);
          });
          assert.match(await chosen(), /selected/);
          await frame.locator('g.object.selected[data-object="0"]').first().waitFor({ state: "attached" });
          await shot("6-click");
        },
      ],
      [
        "the picture is back after a reload of the window",
        async () => {
          // A text that is not saved is kept over a reload only after a while. The click may have left the focus in the picture.
          await until("the saved file", async () => {
            await focusEditor();
            await page.keyboard.press("Control+s");
            return fs.readFileSync(path.join(workbench.files, "lamp.psdl"), "utf8").includes(`${LAMP}0.9\n`);
          });
          await until("no unsaved tab", async () => (await page.locator(".tab.dirty").count()) === 0);
          // As a user does it: a reload of the page may lose what VS Code has not yet written down.
          await page.evaluate(() => (window.before = true));
          await command("Developer: Reload Window");
          await until("another window", async () => {
            try {
              return (await page.evaluate(() => window.before)) === undefined;
            } catch {
              return false; // it is being loaded
            }
          });
          await seen(at.editor, 60_000);
          const frame = await webview("#picture svg");
          await frame.locator('g.object[data-object="0"]').first().waitFor({ state: "attached" });
          assert.equal((await page.locator(at.tab("Scene of lamp.psdl")).count()) > 0, true);
        },
      ],
      [
        "the tree has the objects, and the error",
        async () => {
          await page.locator(at.tab("lamp.psdl")).first().click();
          await command("Focus on Objects View");
          await seen(`${at.tree} ${at.row("table")}`);
          await seen(`${at.tree} ${at.row("chairs")}`);
          await seen(`${at.tree} .monaco-list-row:has-text("lamp") [class*=codicon-error]`);
          await shot("7-tree");
        },
      ],
      [
        "a slider edits the literal, and one undo takes the drag back",
        async () => {
          await command("Focus on Constants View");
          const frame = await webview("#list .row");
          await frame.locator(".row").first().waitFor({ state: "visible" });
          const row = frame.locator(".row").filter({ has: frame.locator('input[aria-label$="line 14"]') }).first();
          await row.waitFor({ state: "visible" });
          const range = row.locator("input.range");
          await range.scrollIntoViewIfNeeded();
          const box = await range.boundingBox();
          await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
          await page.mouse.down();
          for (const part of [0.45, 0.4, 0.35]) await page.mouse.move(box.x + box.width * part, box.y + box.height / 2);
          await page.mouse.up();
          const changed = await until("another number", async () => {
            const line = await lampLine();
            return line !== `${LAMP}0.9` && line;
          });
          assert.match(changed, /^lamp\.min\.z = table\.max\.z \+ -?\d+\.\d+$/);
          await shot("8-slider");
          await focusEditor();
          await until("the number from before", async () => {
            if ((await lampLine()) === `${LAMP}0.9`) return true;
            await page.keyboard.press("Control+z");
            await until("an undo", async () => (await lampLine()) !== changed, 1500).catch(() => undefined);
            return (await lampLine()) === `${LAMP}0.9`;
          });
        },
      ],
      [
        "the button at a slider takes the nearest value without errors",
        async () => {
          const frame = await webview("#list .row");
          const row = frame.locator(".row").filter({ has: frame.locator('input[aria-label$="line 14"]') }).first();
          await row.locator("button.mend").click();
          await lampIs("0.0");
          await until("no squiggle", async () => (await page.locator(at.squiggle).count()) === 0);
          await shot("9-mended");
        },
      ],
      [
        "the object of the line is moved where the user says, and turned",
        async () => {
          await focusEditor();
          await goTo("lamp.center.x");
          await press(() => command("PSDL: Move the Object"), at.quickTitle("Move lamp"));
          await page.locator(at.quickInput).first().fill("x=1.25");
          await shot("10-move");
          await page.keyboard.press("Enter");
          await until("the lamp at its place", async () => (await lineOf("lamp.center.x")) === "lamp.center.x = table.center.x + 1.25");
          await press(() => command("PSDL: Turn the Object"), at.quickTitle("Turn lamp to"));
          await shot("11-turn");
          await page.locator(at.quickRow("X+")).first().click();
          await until("the lamp turned", async () => (await lineOf("lamp.facing")) === "lamp.facing = X_MAX");
        },
      ],
      [
        "the walkthrough has five steps",
        async () => {
          await command("Welcome: Open Walkthrough...");
          await press(() => page.locator(at.quickInput).first().fill("Scene programs"), at.quickRow("Scene programs"));
          await page.locator(at.quickRow("Scene programs")).first().click();
          await until("five steps", async () => (await page.locator(".getting-started-step").count()) === 5);
          await shot("12-walkthrough");
        },
      ],
    ]);
  } catch (error) {
    console.log(error.stack ?? error);
    console.log("0 passed, 1 failed");
    return 1;
  }
})();
await workbench.stop();
process.exit(code);
