package badlog.page

import badlog.core.analysis.Series
import badlog.core.recording.Severity
import badlog.core.recording.Value
import badlog.protocol.HookPart
import badlog.protocol.PageAdditions
import badlog.protocol.PageFigure
import badlog.protocol.PageSeries
import io.kotest.core.annotation.Tags
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

private const val SVG = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 40 20\" onload=\"alert(1)\">" +
    "<script>alert(1)</script><rect width=\"40\" height=\"20\" fill=\"red\"/></svg>"

@Tags("InCheck")
internal class HookSpec : PageSpec({
    val hook = HookPart(
        "tools/analyze.py",
        values = listOf(Value("Energy", "1.7 Ah"), Value("10", "b"), Value("9", "a")),
        findings = listOf(finding("tools/analyze.py", Severity.WARNING, "it sags", 6.0, Double.NaN)),
        series = listOf(
            PageSeries("Fit", "V", Series(doubleArrayOf(0.0, 10.0), doubleArrayOf(0.0, 20.0))),
            PageSeries("Nothing", "", Series(DoubleArray(0), DoubleArray(0))),
        ),
        figures = listOf(
            PageFigure("Energy", "image/svg+xml", base64(SVG.encodeToByteArray())),
            PageFigure("Broken", "image/png", base64(ByteArray(20))),
        ),
    )
    val failed = HookPart("slow.R", error = "it took longer than 30 s")

    browserTest("the section of a hook has its values, lines and pictures, and a failed hook has a reason") {
        val page = TestPages.of(stepBag(graphs = 1), additions = PageAdditions(hooks = listOf(hook, failed)))
        onPage(page, script = "window.alarms = 0; window.alert = () => { window.alarms++ }") {
            step("a hook's section names the hook and has its values, lines and pictures; its findings are listed, and failed hooks have a reason") {
                texts(".hook .folder-name") shouldBe listOf("From the hook tools/analyze.py")
                texts(".hook-note").single() shouldContain "not logged by the robot"
                texts(".hook .value-row .cut-name") shouldBe listOf("Energy", "10", "9")
                texts(".hook .graph-title").take(2) shouldBe listOf("[ Fit ]", "[ Nothing ]")
                texts(".hook .origin").toSet() shouldBe setOf("from tools/analyze.py")
                element(".picture img").getDomAttribute("alt") shouldBe "Energy"
                script("document.querySelector('.picture').scrollIntoView()")
                await("the picture") { number("return document.querySelector('.picture img').naturalWidth") > 0 }
                await("a word about the broken one") { "This picture cannot be drawn." in texts(".picture p") }
                number("return window.alarms") shouldBe 0.0
                elements("#problems svg script, .picture script, .picture svg").size shouldBe 0
                texts(".finding-source") shouldBe listOf("tools/analyze.py")
                element(".problem-list").isDisplayed shouldBe true
                texts(".problem-text").single() shouldBe "The hook slow.R failed: it took longer than 30 s"
            }
            script("scrollTo(0, 0)")
            step("a calculated line is straight between samples, and the cursor still steps by the log's samples") {
                graph("Fit").scrollTo()
                val columns = graph("Fit").lineColumns()
                val height = graph("Fit").picture.height
                columns.max() shouldBeLessThan height / 4
                graph("Fit").frame.x shouldBe graph("Step 1").frame.x
                graph("Fit").frame.width shouldBe graph("Step 1").frame.width
                visibleRange shouldBe 0.0..10.0
            }
        }
    }
})
