package badlog.page.browser

import badlog.page.CountedVideo
import badlog.page.FramePicture
import badlog.page.TestPages
import badlog.page.stepBag
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.openqa.selenium.Keys
import org.openqa.selenium.interactions.KeyInput
import org.openqa.selenium.interactions.PointerInput
import org.openqa.selenium.interactions.PointerInput.Kind
import org.openqa.selenium.interactions.PointerInput.MouseButton
import org.openqa.selenium.interactions.PointerInput.Origin
import org.openqa.selenium.interactions.Sequence
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import java.util.Base64
import kotlin.io.path.exists
import kotlin.io.path.readBytes
import kotlin.math.floor
import kotlin.math.roundToInt

@Tags("InCheck")
internal class PageInChromiumSpec : EveryBrowserSpec(Browser.CHROMIUM)

@Tags("InProve")
internal class PageInOtherBrowsersSpec : EveryBrowserSpec(Browser.FIREFOX, Browser.WEBKIT)

/** The browser features that pages need, tested in each browser. */
internal abstract class EveryBrowserSpec(vararg browsers: Browser) : FunSpec({
    val steps by lazy { TestPages.of(stepBag(graphs = 3)) }

    for (browser in browsers) {
        fun browserTest(name: String, test: BrowserTab.() -> Unit) {
            test("${browser.name}: $name").config(enabledOrReasonIf = { browser.enabled }) { browser.tab.test() }
        }

        browserTest("a page opens from disk, inflates and draws its log, redraws it for paper, and saves the file byte for byte") {
            openPage(steps)
            evaluate("[...document.querySelectorAll('.graph')].map(graph => graph.dataset.name)") shouldBe "Step 1,Step 2,Step 3"
            awaitThat { stepAt() shouldBe (0.3 plusOrMinus 0.01) }
            evaluate("dispatchEvent(new Event('beforeprint'))")
            evaluate("document.querySelectorAll('.graph > svg.paper').length") shouldBe "3"
            evaluate("[...document.querySelectorAll('svg.paper text')].map(text => text.textContent).join()") shouldContain "Step 2 (V)"
            evaluate("dispatchEvent(new Event('afterprint'))")
            evaluate("document.querySelectorAll('svg.paper').length") shouldBe "0"
            val file = browser.downloads.resolve("test.bag")
            Files.deleteIfExists(file)
            evaluate("document.querySelector('#download').click()")
            awaitThat {
                withClue(Files.list(browser.downloads).use { it.toList() }) { file.exists() shouldBe true }
                file.readBytes() shouldBe stepBag(3)
            }
        }

        browserTest("a gzipped log that was cut opens with its readable part, and reports the cut") {
            openPage(TestPages.ofSample("qualification-57.bag.gz"))
            evaluate("document.querySelectorAll('.graph').length > 10") shouldBe "true"
            evaluate("document.querySelector('.problem-list')?.textContent ?? document.body.innerText") shouldContain "cut"
        }

        browserTest("a drag with mouse or finger zooms to its range, and a click on the button shows everything") {
            openPage(steps)
            perform(listOf(path(Kind.MOUSE, listOf(placeAt(0.2), placeAt(0.4), placeAt(0.6)))))
            awaitThat { visibleRange() shouldBe "2–6" }
            awaitThat { stepAt() shouldBe (0.25 plusOrMinus 0.01) }
            perform(listOf(path(Kind.MOUSE, listOf(placeAt(0.5, "#reset")))))
            awaitThat { visibleRange() shouldBe "0–10" }
            perform(listOf(path(Kind.TOUCH, List(9) { placeAt(0.2 + 0.05 * it) })))
            awaitThat { visibleRange() shouldBe "2–6" }
        }

        browserTest("a link contains moment, range and formulas") {
            openPage(steps, "#t=4&x=2:6&f=Twice+~003d+2*Step+1")
            awaitThat { visibleRange() shouldBe "2–6" }
            evaluate("[...document.querySelectorAll('.graph')].map(graph => graph.dataset.name)") shouldContain "Twice"
            awaitThat { stepAt() shouldBe (0.25 plusOrMinus 0.01) }
        }

        browserTest("a typed formula becomes a graph") {
            openPage(steps)
            type("f")
            await("document.activeElement.closest('#formula-dialog') != null")
            type("Half = Step 1 / 2" + Keys.ENTER)
            await("[...document.querySelectorAll('.graph')].some(graph => graph.dataset.name == 'Half')")
        }

        test("${browser.name}: a video that the reader opens follows the cursor, frame by frame").config(enabledOrReasonIf = { drawn(browser) }) {
            browser.tab.run {
                openPage(steps, "#v=1")
                evaluate(CountedVideo.pick)
                awaitVideo()
                for (moment in listOf("4.02", "9.55", "1.32")) {
                    evaluate("location.hash = '#t=$moment'")
                    val frame = floor((moment.toDouble() - 1) * CountedVideo.FRAMES_PER_SECOND).toInt()
                    await("${CountedVideo.SHOWN} == $frame")
                }
                type(".")
                await("${CountedVideo.SHOWN} == 10")
                // WebKitGTK does not report the frame after each jump, so the cursor may stay at the jump's target.
                val reach = if (browser == Browser.WEBKIT) 0.05 else 0.02
                await("Math.abs(parseFloat(document.querySelector('.cursor-readout').textContent) - 1.333) < $reach")
            }
        }

        test("${browser.name}: a video beside the page plays from disk and over HTTP if the page's policy allows it")
            .config(enabledOrReasonIf = { drawn(browser) }) {
                browser.tab.run {
                    val page = TestPages.withVideo(stepBag(graphs = 1), "match 1.webm", CountedVideo.bytes)
                    openPage(page)
                    awaitVideo()
                    FileServer(page.parent).use { server ->
                        open(server.addressOf(page.fileName.toString()))
                        awaitVideo()
                        evaluate("document.querySelector('#video video').currentTime = 5.01")
                        await("document.querySelector('#video video').seeking == false && ${CountedVideo.SHOWN} == 150")
                    }
                    // On its own server, because Firefox already has the video of the other server.
                    FileServer(page.parent).use { server ->
                        val strict = Files.readString(page, Charsets.ISO_8859_1).replace("media-src blob: 'self'", "media-src blob:")
                        Files.writeString(page.resolveSibling("strict.html"), strict, Charsets.ISO_8859_1)
                        open(server.addressOf("strict.html"))
                        await("document.querySelector('#video [role=status]')?.textContent.startsWith('This browser cannot play match 1.webm')")
                        evaluate("document.querySelector('#video video').readyState") shouldBe "0"
                    }
                }
            }
    }
})

/** Returns whether [browser] is installed, and also the browser that draws the video. */
private fun drawn(browser: Browser) = browser.enabled.takeUnless { it.isEnabled } ?: Browser.CHROMIUM.enabled

private fun BrowserTab.awaitVideo() = await("document.querySelector('#video video').readyState >= 2")

private fun BrowserTab.openPage(page: Path, fragment: String = "") {
    open("${page.toUri()}$fragment")
    // A finger that moves slowly because the machine is busy does not rest.
    evaluate("(set => { window.setTimeout = (work, delay, ...more) => delay >= 500 ? 0 : set(work, delay, ...more) })(window.setTimeout)")
    await("['ready', 'failed'].includes(document.documentElement.dataset.state)")
    withClue(evaluate("document.body.innerText.slice(0, 1000)")) { evaluate("document.documentElement.dataset.state") shouldBe "ready" }
    evaluate("localStorage.clear()")
    await("document.documentElement.dataset.rules != null && document.querySelector('.graph canvas') != null")
    settle()
}

/** Returns the range of x that the page displays, in whole units. */
private fun BrowserTab.visibleRange(): String {
    val (from, to) = checkNotNull(Regex("""(-?[\d.]+) – (-?[\d.]+)""").find(evaluate("document.querySelector('.range-readout').textContent"))).destructured
    return "${from.toDouble().roundToInt()}–${to.toDouble().roundToInt()}"
}

private fun BrowserTab.numbers(expression: String): List<Double> = evaluate(expression).split(',').map(String::toDouble)

/** Returns a pixel in the element that matches [selector]. It is at the share [across] of the width and in the middle of the height. */
private fun BrowserTab.placeAt(across: Double, selector: String = ".graph .plot-frame"): Pair<Int, Int> {
    val (x, y, width, height) = numbers("(b => [b.x, b.y, b.width, b.height])(document.querySelector('$selector').getBoundingClientRect())")
    return (x + width * across).roundToInt() to (y + height / 2).roundToInt()
}

/** Returns the position of the step in the first graph's line. It is a share of its width, read from the pixels. */
private fun BrowserTab.stepAt(): Double {
    val place = numbers(
        """
        ((canvas, over) => {
            const box = canvas.getBoundingClientRect(), frame = over.getBoundingClientRect(), ratio = canvas.width / box.width
            return [frame.x - box.x, frame.y - box.y, frame.width, frame.height].map(n => Math.round(n * ratio))
        })(document.querySelector('.graph canvas'), document.querySelector('.graph .plot-frame'))
        """.trimIndent(),
    ).map { it.toInt() }
    val png = Base64.getDecoder().decode(evaluate("document.querySelector('.graph canvas').toDataURL().split(',')[1]"))
    val color = evaluate("getComputedStyle(document.documentElement).getPropertyValue('--line-0').trim()").removePrefix("#").toInt(radix = 16)
    val columns = FramePicture.of(png.inputStream(), place[0], place[1], place[2], place[3]).columnsOf(color)
    return (columns.indexOf(columns.max()) + 0.5) / columns.size
}

/** Returns the sequence of a pointer that goes down at the first of [places], along the others, and up. */
private fun path(kind: Kind, places: List<Pair<Int, Int>>): Sequence {
    val pointer = PointerInput(kind, "$kind")
    return Sequence(pointer, 0).apply {
        places.forEachIndexed { index, (x, y) ->
            addAction(pointer.createPointerMove(Duration.ofMillis(20), Origin.viewport(), x, y))
            if (index == 0) addAction(pointer.createPointerDown(MouseButton.LEFT.asArg()))
        }
        addAction(pointer.createPointerUp(MouseButton.LEFT.asArg()))
    }
}

private fun BrowserTab.type(text: String) {
    val keys = KeyInput("keys")
    perform(
        listOf(
            Sequence(keys, 0).apply {
                for (key in text) {
                    addAction(keys.createKeyDown(key.code))
                    addAction(keys.createKeyUp(key.code))
                }
            },
        ),
    )
    settle()
}
