package badlog.page.browser

import badlog.core.conformance.comparable
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import kotlinx.serialization.json.Json
import java.io.File
import java.nio.file.Files
import java.util.Base64
import kotlin.io.path.createTempDirectory

/** The object to which the compiler adds the exports of the script. */
private const val READER = "globalThis['badlog:page_conformance'].badlog.page.conformance"

@Tags("InCheck")
internal class ConformanceInChromiumSpec : ConformanceInBrowsersSpec(Browser.CHROMIUM)

@Tags("InProve")
internal class ConformanceInOtherBrowsersSpec : ConformanceInBrowsersSpec(Browser.FIREFOX, Browser.WEBKIT)

/** Each browser's JavaScript reads the conformance corpus with the page's parser, all files in one page. */
internal abstract class ConformanceInBrowsersSpec(vararg browsers: Browser) : FunSpec({
    val bags = File(System.getProperty("badlog.conformance")).listFiles()!!.filter { it.extension == "bag" }.sorted()
    val names = bags.map { it.nameWithoutExtension }
    val expected = bags.map { comparable(it.resolveSibling("${it.nameWithoutExtension}.json").readText()) }

    test("the corpus has files") {
        names.size shouldBeGreaterThan 45
    }

    for (browser in browsers) {
        test("${browser.name}: every log of the corpus is read as its JSON says, as a whole, byte by byte and in pieces of 7")
            .config(enabledOrReasonIf = { browser.enabled }) {
                val folder = createTempDirectory("badlog-corpus")
                try {
                    val page = folder.resolve("corpus.html")
                    val encoded = bags.joinToString(",") { "\"${Base64.getEncoder().encodeToString(it.readBytes())}\"" }
                    val reader = File(System.getProperty("badlog.conformance.reader")).readText()
                    val scripts = listOf(reader, "const logs = [$encoded]").joinToString("") { "<script>$it</script>" }
                    Files.writeString(page, "<!DOCTYPE html><meta charset=utf-8><title>Corpus</title>$scripts")
                    browser.tab.open("${page.toUri()}")
                    for (piece in listOf(Int.MAX_VALUE, 1, 7)) {
                        val read = Json.decodeFromString<List<String>>(browser.tab.evaluate("JSON.stringify(logs.map(log => $READER.readLog(log, $piece)))"))
                        (names zip read).toMap() shouldBe (names zip expected).toMap()
                    }
                } finally {
                    folder.toFile().deleteRecursively()
                }
            }
    }
})
