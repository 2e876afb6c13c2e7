package badlog.page.browser

import badlog.viewer.draw.pen.TEXT_TOLERANCE
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import kotlinx.serialization.json.Json
import java.io.File
import java.nio.file.Files
import kotlin.io.path.createTempDirectory

/** The object to which the compiler adds the exports of the script. */
private const val PENS = "globalThis['badlog:page_conformance'].badlog.page.conformance"

@Tags("InCheck")
internal class PensInChromiumSpec : PensInBrowsersSpec(Browser.CHROMIUM)

@Tags("InProve")
internal class PensInOtherBrowsersSpec : PensInBrowsersSpec(Browser.FIREFOX, Browser.WEBKIT)

/** In each browser, the page's pen draws the same as the common pen that writes SVG. So a saved figure equals the screen. */
internal abstract class PensInBrowsersSpec(vararg browsers: Browser) : FunSpec({
    for (browser in browsers) {
        test("${browser.name}: the canvas shows each primitive as SVG does").config(enabledOrReasonIf = { browser.enabled }) {
            val folder = createTempDirectory("badlog-pens")
            try {
                val page = folder.resolve("pens.html")
                val script = File(System.getProperty("badlog.conformance.reader")).readText()
                Files.writeString(page, "<!DOCTYPE html><meta charset=utf-8><title>Pens</title><body><script>$script</script>")
                browser.tab.open("${page.toUri()}")
                val names = Json.decodeFromString<List<String>>(browser.tab.evaluate("JSON.stringify($PENS.penPictures())"))
                names.size shouldBeGreaterThan 15
                for (name in names) {
                    val answer = browser.tab.evaluate("$PENS.penDifferences(${Json.encodeToString(name)}).then(found => JSON.stringify(found))")
                    val differences = Json.decodeFromString<List<Double>>(answer)
                    val (drawn, different) = differences
                    withClue("$name: $answer") {
                        drawn shouldBeGreaterThan 0.1
                        different shouldBeLessThan drawn * TOLERANCE
                        for (place in differences.drop(2)) place shouldBeLessThan TEXT_TOLERANCE
                        if ("text" in name) differences.size shouldBe 4
                    }
                }
            } finally {
                folder.toFile().deleteRecursively()
            }
        }
    }
})

/** The tolerance for smoothed edges. Firefox also places the letters of a picture between pixels. */
private const val TOLERANCE = 0.07
