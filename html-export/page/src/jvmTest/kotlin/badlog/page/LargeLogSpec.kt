package badlog.page

import badlog.formats.wpilog.largeLog
import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import org.openqa.selenium.Keys

/** A log of hundreds of topics. */
@Tags("InCheck")
internal class LargeLogSpec : PageSpec({
    val page by lazy { TestPages.of(largeLog(), "large.wpilog", PageAdditions(rules = RuleSet.BUILT_IN)) }

    fun OpenPage.find(words: String) {
        click("#search")
        act { keyDown(Keys.CONTROL).sendKeys("a").keyUp(Keys.CONTROL) }
        press(words)
        settle()
    }

    fun OpenPage.seen(selector: String): List<String> = elements(selector).filter { it.isDisplayed }.map { it.text.replace('\n', ' ') }

    /** The names of the graphs in the folders, below the board. */
    fun OpenPage.namesInFolders(): List<String> = elements(".content .graph").filter { it.isDisplayed }.mapNotNull { it.getDomAttribute("data-name") }

    browserTest("a log of more than 700 topics is searched, compared and pinned, on a page that scrolls") {
        onPage(page, Screen(1366, 768)) {
            step("a log of more than 700 topics begins with at most 60 graphs, on a page that scrolls, with a tree of folders") {
                val topics = texts(".facts .fact").first { it.endsWith("topics") }.filter { it in '0'..'9' }.toInt()
                topics shouldBeGreaterThan 700
                graphNames.size shouldBeLessThanOrEqual 60
                graphNames shouldContain "Chassis/Module speeds"
                graphNames shouldContain "DS:joystick0/axes"
                number("return document.documentElement.scrollHeight") shouldBeLessThan 25_000.0
                keepScreenshot("large-wide-light")
                seen(".folder-inner .folder-link").map { it.substringBefore(' ') } shouldContain "limelight-front"
                find("frontleft speed")
                seen(".folder-link") shouldContainExactly listOf("Chassis 1")
                press(Keys.ESCAPE)
                show(Screen(390, 844, density = 2.0, isPhone = true, isDark = true))
                keepScreenshot("large-phone-dark")
            }
            show(Screen.WIDE)
            step("target and actual speed of a swerve module are compared after one search, on a laptop and on a phone") {
                for (screen in listOf(Screen(1366, 768), Screen.PHONE)) {
                    show(screen)
                    script("scrollTo(0, 0)")
                    find("frontleft speed")
                    namesInFolders() shouldContainExactly listOf("Chassis/Module speeds")
                    val top = number("return document.querySelector('.content .graph:not([hidden]) canvas').getBoundingClientRect().top")
                    top shouldBeLessThan screen.height - 100.0
                    val lines = elements(".content .graph .legend-entry").filter { it.isDisplayed }.mapNotNull { it.getDomProperty("title") }
                    lines.map { it.substringBefore(" –") } shouldContainExactly
                        listOf("/Chassis/TargetFrontLeftModuleState/speed", "/Chassis/ActualFrontLeftModuleState/speed")
                    keepScreenshot("large-compare-${screen.width}")
                    press(Keys.ESCAPE)
                    elements(".content .graph[data-name='Chassis/Module speeds'] .legend-entry").count { it.isDisplayed } shouldBe 8
                }
            }
            show(Screen.WIDE)
            script("scrollTo(0, 0)")
            step("a search matches listed, constant and empty topics; a click draws a topic with samples, and its pin adds it to the board") {
                fun pinOf(row: String) = "$row .pin"
                val before = elements("#board .graph").size
                val name = checkNotNull(elements(".listed-graph[data-name]").first().getDomAttribute("data-name"))
                click(pinOf(".listed-row"))
                elements("#board .graph").size shouldBe before + 1
                elements("#board .graph").last().getDomAttribute("data-name") shouldBe name
                element(pinOf(".listed-row")).getDomAttribute("aria-pressed") shouldBe "true"
                click("#constants .folder-toggle")
                click(pinOf("#constants tr"))
                elements("#board .graph").size shouldBe before + 2
                click(pinOf("#constants tr"))
                elements("#board .graph").size shouldBe before + 1
                script("document.querySelector('.listed-row').scrollIntoView({block: 'center', behavior: 'instant'})")
                settle()
                click(pinOf(".listed-row"))
                elements("#board .graph").size shouldBe before
                val drawn = graphNames
                click(".listed-graph[data-name]")
                graphNames.size shouldBe drawn.size + 1
                graph(name).scrollTo().isDrawn shouldBe true
                find("camera 27/inputsave")
                seen("#empty-topics tr") shouldContainExactly listOf("NT:/photonvision/camera 27/inputSaveImgCmd")
                find("wrist error")
                namesInFolders() shouldContainExactly listOf("/Wrist/Error")
                find("primitive 3/heading")
                seen("#constants tr") shouldContain "NT:/Primitive 3/Heading 6.5"
                click("#constants tr:not([hidden]) button")
                graph("NT:/Primitive 3/Heading").isOnScreen shouldBe true
                press(Keys.ESCAPE)
                graphNames.size shouldBeLessThanOrEqual drawn.size + 2
            }
        }
    }
})
