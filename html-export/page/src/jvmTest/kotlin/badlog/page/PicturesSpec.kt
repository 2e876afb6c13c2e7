package badlog.page

import badlog.core.analysis.Series
import badlog.core.recording.Severity
import badlog.core.recording.Value
import badlog.protocol.HookPart
import badlog.protocol.PageAdditions
import badlog.protocol.PageFigure
import badlog.protocol.PageSeries
import io.kotest.core.annotation.Tags
import org.openqa.selenium.Keys

/** Saves pictures of the page under `build/screenshots` for review. */
@Tags("InCheck")
internal class PicturesSpec : PageSpec({
    val match = "qualification-42.bag"

    val colors = mapOf("light" to false, "dark" to true)

    browserTest("pictures of a match: wide and on a phone, light and dark, zoomed, with cursors, statistics, info, help and searches") {
        onPage(TestPages.ofSample(match)) {
            step("a match, light and dark, on a wide screen and on a phone") {
                for ((color, isDark) in colors) {
                    show(Screen.WIDE.copy(isDark = isDark))
                    script("scrollTo(0, 0)")
                    settle()
                    keepScreenshot("wide-$color")
                    graph("System/Battery Voltage").scrollTo().hover(0.6)
                    keepScreenshot("wide-$color-cursor")
                }
                for ((color, isDark) in colors) {
                    show(Screen.PHONE.copy(isDark = isDark))
                    script("scrollTo(0, 0)")
                    settle()
                    keepScreenshot("phone-$color")
                    graph("System/Battery Voltage").scrollTo()
                    press(Keys.ARROW_RIGHT)
                    keepScreenshot("phone-$color-cursor")
                    click("#values-button")
                    keepScreenshot("phone-$color-values")
                    click("#values-button")
                }
                show(Screen.WIDE)
            }
            step("the statistics and the info, the help, a search, and a search without matches") {
                val graph = graph("System/Battery Voltage").scrollTo()
                script("arguments[0].querySelector('.statistics-toggle').click()", graph.card)
                keepScreenshot("statistics")
                script("window.scrollTo(0, 1e6)")
                settle()
                keepScreenshot("info")
                script("window.scrollTo(0, 0)")
                press("?")
                keepScreenshot("help")
                press(Keys.ESCAPE)
                press("/")
                press("current")
                keepScreenshot("search")
                press("xyz")
                keepScreenshot("search-nothing")
            }
            press(Keys.ESCAPE)
            script("document.activeElement.blur()")
            step("the brownout, zoomed in") {
                graph("System/Battery Voltage").scrollTo().drag(0.56, 0.66)
                graph("System/Battery Voltage").hover(0.4)
                keepScreenshot("zoomed")
                graph("Drivetrain/Velocities").scrollTo()
                keepScreenshot("zoomed-drivetrain")
                press("v")
                graph("System/Battery Voltage").scrollTo().click(0.3)
                graph("System/Battery Voltage").click(0.7, withShift = true)
                graph("System/Battery Voltage").hover(0.5)
                keepScreenshot("cursors")
            }
        }
    }

    val additions by lazy {
        val findings = List(12) { i ->
            val until = if (i % 4 == 0) 12.0 * i + 5 else Double.NaN
            finding("Rule ${i % 4}", Severity.entries[i % 3], "finding $i", 12.0 * i, until)
        }
        val svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 300 100\">" +
            "<path d=\"M5 90L150 20L295 60\" fill=\"none\" stroke=\"black\"/></svg>"
        val hook = HookPart(
            "analyze.py",
            values = listOf(Value("Energy", "1.69 Ah")),
            findings = listOf(finding("analyze.py", Severity.WARNING, "it sags", 60.0, 75.0)),
            series = listOf(PageSeries("Fit", "V", Series(doubleArrayOf(0.0, 150.0), doubleArrayOf(12.6, 11.4)))),
            figures = listOf(PageFigure("Energy", "image/svg+xml", base64(svg.encodeToByteArray()))),
        )
        val formulas = listOf("PDP/Power [W] = Battery Voltage * Total Current", "Bad = Battery Voltge")
        TestPages.ofSample(match, PageAdditions(formulas, findings = findings, hooks = listOf(hook, HookPart("slow.R", "it took longer than 30 s"))))
    }

    browserTest("findings, a formula and a hook's section, wide and on a phone, light and dark, and a file that was cut by a loss of power") {
        onPage(additions) {
            for (screen in listOf(Screen.WIDE, Screen.PHONE)) {
                for ((color, isDark) in colors) {
                    val name = (if (screen.isPhone) "phone-" else "wide-") + color
                    show(screen.copy(isDark = isDark))
                    script("scrollTo(0, 0)")
                    settle()
                    keepScreenshot("findings-$name")
                    press("n", "n")
                    keepScreenshot("finding-$name")
                    graph("Fit").scrollTo()
                    keepScreenshot("hook-$name")
                    press("f")
                    press("Mean = (left velocity + righ")
                    keepScreenshot("formula-$name")
                    press(Keys.ESCAPE)
                    press(Keys.ESCAPE)
                }
            }
        }
        onPage(TestPages.ofSample("practice.bag")) { keepScreenshot("cut") }
    }
})
