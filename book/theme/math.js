// Renders GitHub's math syntax: $`inline`$ and fences tagged `math`.
(() => {
    const options = { output: "htmlAndMathml", throwOnError: false };
    const render = (tex, place, displayMode) =>
        katex.render(tex, place, { ...options, displayMode });

    document.querySelectorAll("pre > code.language-math").forEach((code) => {
        const block = document.createElement("div");
        block.className = "equation";
        code.parentElement.replaceWith(block);
        render(code.textContent, block, true);
    });
    document.querySelectorAll("code").forEach((code) => {
        const before = code.previousSibling, after = code.nextSibling;
        if (!before?.data?.endsWith("$") || !after?.data?.startsWith("$")) return;
        before.data = before.data.slice(0, -1);
        after.data = after.data.slice(1);
        const span = document.createElement("span");
        code.replaceWith(span);
        render(code.textContent, span, false);
    });
})();
// Listings come from the middle of a file: moves them to the left margin.
document.querySelectorAll("code.language-rust").forEach((code) => {
    const lines = code.textContent.split("\n").filter((line) => line.trim());
    const margin = Math.min(...lines.map((line) => line.search(/\S/)));
    if (!(margin > 0 && margin < Infinity)) return;
    const indent = new RegExp(`^ {${margin}}`, "gm");
    code.innerHTML = code.innerHTML.replace(indent, "");
});

// What .ci/browser asks for: formulas, formulas that failed, pictures that did not load.
addEventListener("load", () => {
    const count = (selector) => document.querySelectorAll(selector).length;
    const broken = [...document.images].filter((image) => image.naturalWidth === 0);
    document.documentElement.dataset.check =
        `formulas=${count(".katex")} failed=${count(".katex-error")} ` +
        `pictures=${document.images.length} broken=${broken.length}`;
});
