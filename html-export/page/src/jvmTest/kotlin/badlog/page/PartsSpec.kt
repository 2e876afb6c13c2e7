package badlog.page

import io.kotest.core.annotation.Tags
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Files

private const val ROWS = 120_000

/**
 * A log of some megabytes, so that the page has several parts. Parts end anywhere in rows, and texts contain commas, quotes and newlines.
 */
private val HEADER = """
    {"topics":[{"name":"Time","unit":"s","attrs":["xaxis","hide"]},{"name":"Angle","unit":"deg","attrs":["differentiate"]},
    {"name":"Current","unit":"A"},{"name":"State"},{"name":"Enabled"},{"name":"Log","attrs":["log"]}]}
""".trimIndent().replace("\n", "") + "\nTime,Angle,Current,State,Enabled,Log\n"

private fun row(row: Int): String {
    val said = when {
        row % 7000 == 11 -> "\"armed, ready at $row\""
        row % 9000 == 12 -> "\"said \"\"go\"\"\ntwice at $row\""
        else -> ""
    }
    val current = if (row % 500 < 20) "" else "${row % 331 * 0.125}"
    return "${row * 0.02},${row % 977 * 1.0625},$current,${if (row % 800 < 300) "LOW" else "HIGH"},${row > 3000},$said\n"
}

private val CLEAN = HEADER + (0 until ROWS).joinToString("", transform = ::row)

private val DAMAGED = HEADER + (0 until ROWS).joinToString("") {
    when (it) {
        20_000 -> "400.0,1,2,\"LOW,true,\n"
        30_000 -> "600.0,1,2\n"
        40_000 -> "\u0000\u0000\u0000\u0000${row(it)}"
        else -> row(it)
    }
}.dropLast(7)

/** Pages of logs that several workers read at the same time. */
@Tags("InCheck")
internal class PartsSpec : PageSpec({
    fun cores(count: Int) = "Object.defineProperty(navigator, 'hardwareConcurrency', { get: () => $count })"

    fun OpenPage.readInParts() = number("return performance.getEntriesByName('badlog-parts-read').length").toInt()

    fun OpenPage.shown() = listOf(
        script("return document.body.textContent"),
        script("return [...document.querySelectorAll('section.graph canvas')].map(c => c.toDataURL()).join()"),
    )

    fun OpenPage.whatIsLeft(): List<Any?> {
        click("#show-damaged")
        awaitState("ready")
        return shown()
    }

    browserTest("several workers read a whole log, and a damaged one, with the same result as one") {
        for (log in listOf(CLEAN, DAMAGED)) {
            val page = TestPages.of(log)
            var expected = emptyList<Any?>()
            onPage(page, script = cores(1)) {
                readInParts() shouldBe 0
                expected = shown()
            }
            onPage(page, script = cores(if (log === CLEAN) 2 else 3)) {
                readInParts() shouldBe 1
                shown() shouldBe expected
            }
        }
    }

    browserTest("a large log is read while the rest of its page is still loading") {
        val text = Files.readString(TestPages.of(CLEAN))
        val middle = text.indexOf("id=\"recording\"").let { it + (text.indexOf("</script>", it) - it) / 2 }
        onPage(TestPages.of("a\n1\n", "b.csv")) {
            script(
                """
                window.taken = 0
                const Real = Worker
                window.Worker = class extends Real {
                    constructor(...all) {
                        super(...all)
                        this.addEventListener('message', event => { if (event.data.part !== undefined) window.taken++ })
                    }
                }
                document.open()
                document.write(arguments[0])
                """.trimIndent(),
                text.take(middle),
            )
            await("a part to be read") { number("return window.taken") > 0 }
            state shouldBe "loading"
            script("document.write(arguments[0]); document.close()", text.drop(middle))
            awaitState("ready")
            readInParts() shouldBe 1
            texts(".fact").joinToString() shouldContain "120 000 samples each"
        }
    }

    browserTest("fast workers wait for a slow one, so that no more than a few parts are held") {
        // The answer of one part is held until all other parts are answered, twice in a row. In between, the page looks again for text to
        // send.
        val held = """
            ${cores(2)};
            window.sent = 0; window.answered = 0;
            const post = Worker.prototype.postMessage;
            Worker.prototype.postMessage = function (message, ...more) {
                if (message?.part !== undefined) window.sent++;
                return post.call(this, message, ...more);
            };
            const release = (answer, seen) => {
                const isIdle = document.readyState !== 'loading' && window.answered === window.sent - 1;
                if (isIdle && seen === window.sent) { window.early = window.sent; answer() }
                else setTimeout(() => release(answer, isIdle ? window.sent : -1), 50);
            };
            Object.defineProperty(Worker.prototype, 'onmessage', { set(receive) {
                this.addEventListener('message', event => {
                    if (event.data.part === 1) return release(() => receive(event), -1);
                    if (event.data.part !== undefined) window.answered++;
                    receive(event);
                });
            } });
        """.trimIndent().replace("\n", " ")
        val rows = (0 until 1000).joinToString("", transform = ::row)
        onPage(TestPages.of(HEADER + rows.repeat(26_000_000 / rows.length)), script = held) {
            readInParts() shouldBe 1
            number("return window.sent").toInt() shouldBeGreaterThan 12
            number("return window.early").toInt() shouldBe 1 + 2 * 4
        }
    }

    browserTest("a page with a damaged part is read as one stream, up to the damage, if its reader asks for it") {
        val text = Files.readString(TestPages.of(CLEAN))
        val from = text.indexOf("id=\"recording\"")
        val middle = from + (text.indexOf("</script>", from) - from) / 2
        val file = Files.createTempFile("badlog-parts", ".html")
        file.toFile().deleteOnExit()
        Files.writeString(file, text.replaceRange(middle, middle + 400, "A".repeat(400)))
        var expected = emptyList<Any?>()
        onPage(file, script = cores(1), state = "failed") { expected = whatIsLeft() }
        onPage(file, script = cores(2), state = "failed") {
            readInParts() shouldBe 0
            whatIsLeft() shouldBe expected
        }
    }
})
