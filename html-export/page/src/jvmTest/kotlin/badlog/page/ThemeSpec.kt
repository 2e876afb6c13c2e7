package badlog.page

import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.inspectors.forAll
import io.kotest.matchers.doubles.shouldBeGreaterThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe

@Tags("InCheck")
internal class ThemeSpec : PageSpec({
    /** Selectors of the texts that must be readable. */
    val texts = listOf(
        "h1", ".facts", ".fact", "#problems summary", ".problem-text", ".problem-place", ".severity", ".search-input",
        ".range-readout", ".cursor-readout", ".event-readout", "#download", ".folder-link-name", ".count",
        ".folder-toggle", ".graph-title", ".unit", ".legend-name", ".value", ".x-title", ".value-row .cut-name", ".value-row .value-text",
        ".event-go", ".event .finding-text", "#info summary", ".text-button", ".event-label",
    )

    /** Returns the contrast between a text and its background, as defined by WCAG; null if there is no such text. */
    fun OpenPage.contrast(selector: String): Double? = script(
        """
        const all = [...document.querySelectorAll(arguments[0])];
        const e = all.find(e => e.checkVisibility() && !e.closest('[disabled]'));
        if (!e) return null;
        const rgba = text => {
            const c = new OffscreenCanvas(1, 1).getContext('2d', {willReadFrequently: true});
            c.fillStyle = text; c.fillRect(0, 0, 1, 1);
            const d = c.getImageData(0, 0, 1, 1).data;
            return [d[0], d[1], d[2], d[3] / 255];
        };
        const mix = (top, below) => below.slice(0, 3).map((b, i) => top[i] * top[3] + b * (1 - top[3])).concat(1);
        const light = c => {
            const [r, g, b] = c.map(v => v / 255).map(v => v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
            return 0.2126 * r + 0.7152 * g + 0.0722 * b;
        };
        const layers = [];
        for (let p = e; p; p = p.parentElement) layers.push(rgba(getComputedStyle(p).backgroundColor));
        let ground = [255, 255, 255, 1];
        for (const layer of layers.reverse()) ground = mix(layer, ground);
        const text = mix(rgba(getComputedStyle(e).color), ground);
        const [a, b] = [light(text), light(ground)];
        return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
        """.trimIndent(),
        selector,
    )?.let { (it as Number).toDouble() }

    browserTest("a dark system gets a dark page, a light one a light page, with a contrast of texts of at least 4.5 to 1") {
        onPage(TestPages.ofSample("practice.bag"), Screen.WIDE.copy(isDark = true)) {
            for (isDark in listOf(true, false)) {
                val name = if (isDark) "dark" else "light"
                show(Screen.WIDE.copy(isDark = isDark))
                element("html").getDomAttribute("data-theme") shouldBe name
                graph(graphNames.first()).scrollTo().hover(0.5)
                withClue(name) {
                    texts.forAll { selector ->
                        withClue(selector) { contrast(selector)?.let { it shouldBeGreaterThanOrEqual 4.5 } }
                    }
                }
            }
        }
    }

    browserTest("the page follows the system’s theme until the button selects another") {
        onPage(TestPages.of(stepBag(graphs = 3))) {
            step("the page follows a change of the system's theme, and redraws its graphs in the new colors") {
                val light = graph("Step 1").canvas
                show(Screen.WIDE.copy(isDark = true))
                element("html").getDomAttribute("data-theme") shouldBe "dark"
                graph("Step 1").canvas shouldNotBe light
                graph("Step 1").steepest()
                show(Screen.WIDE)
                graph("Step 1").canvas shouldBe light
            }
            step("the button selects light and dark, also after a reload") {
                click("#theme")
                element("html").getDomAttribute("data-theme") shouldBe "light"
                click("#theme")
                element("html").getDomAttribute("data-theme") shouldBe "dark"
                reload()
                element("html").getDomAttribute("data-theme") shouldBe "dark"
                click("#theme")
                element("html").getDomAttribute("data-theme") shouldBe "light"
            }
        }
    }
})
