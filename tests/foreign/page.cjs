// Opens pages in a browser: node page.cjs BROWSER PAGE... One JSON line a check. With PSDL_SHOTS=FOLDER, pictures are kept there.
const path = require("path");
const { pathToFileURL } = require("url");
const puppeteer = require("puppeteer-core");

const [browserPath, ...pages] = process.argv.slice(2);
const shots = process.env.PSDL_SHOTS;

(async () => {
  const browser = await puppeteer.launch({
    executablePath: browserPath,
    args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--window-size=1200,800"],
    defaultViewport: { width: 1200, height: 800 },
  });
  for (const file of pages) {
    const name = path.basename(file), said = [], asked = [];
    const tell = (what, good, why) => console.log(JSON.stringify({ page: name, what, good: Boolean(good), why }));
    const page = await browser.newPage();
    page.on("console", (message) => { if (["error", "warn"].includes(message.type()) && !/GPU stall|GL Driver/.test(message.text())) said.push(message.text()); });
    page.on("pageerror", (error) => said.push(String(error)));
    page.on("dialog", (dialog) => { said.push("a dialog: " + dialog.message()); dialog.dismiss(); });
    const url = pathToFileURL(file).href;
    page.on("request", (request) => { if (request.url() !== url && !request.url().startsWith("data:")) asked.push(request.url()); });
    await page.goto(url);
    const settle = () => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    const shoot = async (suffix) => { if (shots) await page.screenshot({ path: path.join(shots, `${name}.${suffix}.png`) }); };
    const text = (id) => page.$eval("#" + id, (element) => element.textContent);
    await settle();
    await shoot("1-perspective");
    const data = JSON.parse(await text("data"));
    tell("lists every finding", (await page.$$("#findings li")).length === data.findings.length);
    if (data.objects.length) {
      await page.focus("#view");
      await page.keyboard.press("n");
      await settle();
      tell("steps to an object by key", (await text("said")).includes(data.objects[0].path.slice(0, 100)), await text("said"));
      await page.keyboard.press("t");
      await page.keyboard.press("Escape");
      await page.keyboard.press("r");
      await settle();
      await shoot("2-top");
      // Somewhere over the view there is an object under the pointer.
      const box = await (await page.$("#view")).boundingBox();
      let found = "";
      for (let i = 0; i < 400 && !found; i++) {
        await page.mouse.move(box.x + box.width * ((i % 20) + 0.5) / 20, box.y + box.height * (Math.floor(i / 20) + 0.5) / 20);
        found = await page.$eval("#tip", (tip) => (tip.hidden ? "" : tip.textContent));
      }
      tell("names what is under the pointer", data.objects.some((o) => found.includes(o.path.slice(0, 100))), found);
      await page.keyboard.press("p");
      await page.keyboard.press("l");
      await settle();
      await shoot("3-names");
      await page.keyboard.press("l");
    }
    const first = await page.$("#findings button");
    if (first) {
      await first.click();
      await settle();
      tell("a finding can be chosen", (await page.$eval("#findings button", (b) => b.getAttribute("aria-pressed"))) === "true");
      await shoot("4-finding");
    }
    await page.focus("#view");
    for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowLeft");
    await settle();
    tell("says nothing on the console", said.length === 0, said.join("; ").slice(0, 500));
    tell("asks for nothing", asked.length === 0, asked.join(" ").slice(0, 500));
    
    await page.close();
  }
  await browser.close();
})().catch((error) => { console.error(error); process.exit(1); });
