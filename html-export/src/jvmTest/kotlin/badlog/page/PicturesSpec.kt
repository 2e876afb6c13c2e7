package badlog.page

import org.openqa.selenium.Keys

/** Keeps pictures of the page under `build/screenshots`, for people to look at. */
internal class PicturesSpec : PageSpec({
    val match = "qualification-42.bag"

    for (isDark in listOf(false, true)) {
        val colours = if (isDark) "dark" else "light"
        browserTest("a match on a wide screen, $colours") {
            onPage(TestPages.ofSample(match), Screen.WIDE.copy(isDark = isDark)) {
                keepScreenshot("wide-$colours")
                graph("System/Battery Voltage").scrollTo().hover(0.6)
                keepScreenshot("wide-$colours-cursor")
            }
        }

        browserTest("a match on a phone, $colours") {
            onPage(TestPages.ofSample(match), Screen.PHONE.copy(isDark = isDark)) {
                keepScreenshot("phone-$colours")
                graph("System/Battery Voltage").scrollTo()
                press(Keys.ARROW_RIGHT)
                keepScreenshot("phone-$colours-cursor")
            }
        }
    }

    browserTest("the brownout, zoomed in on") {
        onPage(TestPages.ofSample(match)) {
            graph("System/Battery Voltage").scrollTo().drag(0.56, 0.66)
            graph("System/Battery Voltage").hover(0.4)
            keepScreenshot("zoomed")
            graph("Drivetrain/Velocities").scrollTo()
            keepScreenshot("zoomed-drivetrain")
        }
    }

    browserTest("a search, and one that finds nothing") {
        onPage(TestPages.ofSample(match)) {
            press("/")
            press("current")
            keepScreenshot("search")
            press("xyz")
            keepScreenshot("search-nothing")
        }
    }

    browserTest("a file that was cut by a loss of power") {
        onPage(TestPages.ofSample("practice.bag")) { keepScreenshot("cut") }
    }

    browserTest("the help") {
        onPage(TestPages.ofSample(match)) {
            press("?")
            keepScreenshot("help")
        }
    }

    browserTest("the statistics and the info") {
        onPage(TestPages.ofSample(match)) {
            val graph = graph("System/Battery Voltage").scrollTo()
            script("arguments[0].querySelector('.statistics-toggle').click()", graph.card)
            keepScreenshot("statistics")
            script("window.scrollTo(0, 1e6)")
            settle()
            keepScreenshot("info")
        }
    }
})
