package badlog.page

import badlog.core.waiting.eventually
import io.kotest.assertions.withClue
import io.kotest.matchers.shouldBe
import org.openqa.selenium.By
import org.openqa.selenium.Keys
import org.openqa.selenium.OutputType
import org.openqa.selenium.WebDriverException
import org.openqa.selenium.WebElement
import org.openqa.selenium.WindowType
import org.openqa.selenium.chrome.ChromeDriver
import org.openqa.selenium.interactions.Actions
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration

/**
 * A page in the one tab of all tests. A new tab would start a process that compiles the page's script again. Only a page that is opened
 * beside another page has its own tab.
 *
 * @param address its first address.
 * @param before the tab of the page beside which it is opened; null if there is none.
 */
internal class OpenPage private constructor(val driver: ChromeDriver, private val address: String, private val before: String?) :
    AutoCloseable {
    private val logs = PageLogs(driver)

    /** The scripts that run in it before its own script, by the names that the browser has given them. */
    private val scripts = ArrayList<String>()

    /** The state that the page reports. */
    val state: String? get() = script("return document.documentElement.dataset.state") as String?

    /** Waits until the page reports [state]. If it is ready, also waits until its rules are done, because findings change the page. */
    fun awaitState(state: String) {
        await("the page's state $state") { isIn(state) }
        withClue(text) { this.state shouldBe state }
        settle()
    }

    /** Whether the page reports [state] or a failure. The script itself waits a moment, because each question takes time from the page. */
    private fun isIn(state: String): Boolean = driver.executeAsyncScript(
        """
        const [state, done] = arguments
        const page = document.documentElement
        const isSo = () => page.dataset.state === 'failed' || page.dataset.state === state && (state !== 'ready' || page.dataset.rules)
        if (isSo()) return done(true)
        const end = isNow => { watch.disconnect(); done(isNow) }
        const watch = new MutationObserver(() => { if (isSo()) end(true) })
        watch.observe(page, { attributes: true })
        setTimeout(() => end(false), 400)
        """.trimIndent(),
        state,
    ) as Boolean

    /** All text on the page. */
    val text: String get() = script("return document.body.innerText") as String

    /** Returns the first element that matches [selector]. */
    fun element(selector: String): WebElement = driver.findElement(By.cssSelector(selector))

    /** Returns all elements that match [selector]. */
    fun elements(selector: String): List<WebElement> = driver.findElements(By.cssSelector(selector))

    /** Returns the texts of the elements that match [selector], visible or not. */
    fun texts(selector: String): List<String> = strings(
        script("return [...document.querySelectorAll(arguments[0])].map(e => e.textContent)", selector),
    )

    /** The names of the files in the list of logs, in order. */
    val listedLogs: List<String> get() = strings(script("return $LISTED.map(row => row.dataset.path.split('/').pop())"))

    /** Opens the first listed log with [part] in its file name. */
    fun openListed(part: String) = script("$LISTED.find(row => row.dataset.path.split('/').pop().includes(arguments[0])).click()", part)

    /** The names of all visible graphs, in order. */
    val graphNames: List<String>
        get() = strings(
            script(
                "return [...document.querySelectorAll('.graph')].filter(e => e.checkVisibility())" +
                    ".map(e => e.dataset.name)",
            ),
        )

    /** The range of x that the page displays. */
    val visibleRange: ClosedFloatingPointRange<Double>
        get() {
            val said = texts(".range-readout").single()
            val found = checkNotNull(Regex("""(-?[\d.]+) – (-?[\d.]+)""").find(said)) { "No range in “$said”" }
            val (from, to) = found.destructured
            return from.toDouble()..to.toDouble()
        }

    /** Returns the color that the style sheet calls [name] in the current theme. */
    fun color(name: String): Int {
        val style = "getComputedStyle(document.documentElement).getPropertyValue(arguments[0])"
        return (script("return $style.trim()", name) as String).removePrefix("#").toInt(radix = 16)
    }

    /** Runs [source] whenever the page is loaded, before its own script. */
    fun runFirst(source: String) {
        val added = driver.executeCdpCommand("Page.addScriptToEvaluateOnNewDocument", mapOf("source" to source))
        scripts += added.getValue("identifier") as String
    }

    /** Runs JavaScript. */
    fun script(code: String, vararg arguments: Any?): Any? = driver.executeScript(code, *arguments)

    /** Returns the result of JavaScript that is a number. */
    fun number(code: String, vararg arguments: Any?): Double = (script(code, *arguments) as Number).toDouble()

    /** Waits until the page has handled and drawn the last action, and has nothing left to do soon. */
    fun settle() {
        driver.executeAsyncScript("window.settled ? window.settled(arguments[0]) : setTimeout(arguments[0])")
    }

    /** Waits for [what], also while the page recreates the elements that [isSo] reads. */
    fun await(what: String, isSo: () -> Boolean) {
        try {
            eventually(what, isSo)
        } catch (e: AssertionError) {
            throw AssertionError("${e.message} The page shows:\n${text.take(MAX_TEXT)}", e)
        }
    }

    /** Lets the time pass for which the page's held timers wait. */
    fun passTime() {
        script("window.passTime?.()")
        settle()
    }

    /** Performs mouse and key actions with the browser's own driver. */
    fun act(steps: Actions.() -> Actions) {
        Actions(driver, Duration.ofMillis(POINTER_MILLISECONDS)).steps().perform()
        settle()
    }

    /** Types [keys] into the focused element. */
    fun press(vararg keys: CharSequence) = act { sendKeys(*keys) }

    /** Clicks the first element that matches [selector] and [accepts], or its replacement if the page recreated it before the click. */
    fun click(selector: String, accepts: (WebElement) -> Boolean = { true }) {
        await("a click on $selector") {
            val found = elements(selector)
            checkNotNull(found.firstOrNull(accepts)) { "None of the ${found.size} elements that $selector finds is to be clicked." }.click()
            true
        }
        settle()
    }

    /** Holds Shift while [keys] are typed. */
    fun pressShift(vararg keys: CharSequence) = act { keyDown(Keys.SHIFT).sendKeys(*keys).keyUp(Keys.SHIFT) }

    /** Shows the page on another [screen]. */
    fun show(screen: Screen) {
        emulate(screen)
        await("the width of ${screen.width}") { number("return innerWidth").toInt() == screen.width }
        await("its colors") { script("return matchMedia('(prefers-color-scheme: dark)').matches") == screen.isDark }
        settle()
    }

    private fun emulate(screen: Screen) {
        driver.executeCdpCommand(
            "Emulation.setDeviceMetricsOverride",
            mapOf(
                "width" to screen.width,
                "height" to screen.height,
                "deviceScaleFactor" to screen.density,
                "mobile" to screen.isPhone,
            ),
        )
        driver.executeCdpCommand("Emulation.setTouchEmulationEnabled", mapOf("enabled" to screen.isPhone))
        val scheme = mapOf("name" to "prefers-color-scheme", "value" to if (screen.isDark) "dark" else "light")
        val calm = mapOf("name" to "prefers-reduced-motion", "value" to "reduce")
        driver.executeCdpCommand("Emulation.setEmulatedMedia", mapOf("features" to listOf(scheme, calm)))
    }

    /** Loads the page again. */
    fun reload() {
        driver.navigate().refresh()
        awaitState("ready")
    }

    /** Opens the page again as it was at first, and waits until it reports [state]. */
    fun startOver(state: String = "ready") {
        forget()
        driver.get("about:blank")
        forgetWay()
        driver.get(address)
        awaitState(state)
    }

    /** Clears the browser's storage, which all pages on a disk share. */
    private fun forget() {
        driver.executeScript("try { localStorage.clear(); sessionStorage.clear() } catch { }")
    }

    /** Clears the tab's history, which is full after some pages: a page goes other ways then. */
    private fun forgetWay() {
        driver.executeCdpCommand("Page.resetNavigationHistory", emptyMap<String, Any>())
    }

    /** Returns what the page wrote to the console: warnings and errors. */
    fun consoleMessages(): List<String> = logs.messages()

    /** Returns the addresses that the page requested. */
    fun requests(): List<String> = logs.requests()

    /** Saves a screenshot of the page for review. */
    fun keepScreenshot(name: String) {
        val file = Path.of("build", "screenshots", "$name.png")
        Files.createDirectories(file.parent)
        Files.write(file, driver.getScreenshotAs(OutputType.BYTES))
    }

    override fun close() {
        if (before == null) isTabTaken = false
        forget()
        for (script in scripts) driver.executeCdpCommand("Page.removeScriptToEvaluateOnNewDocument", mapOf("identifier" to script))
        if (before == null) {
            driver.get("about:blank")
        } else {
            driver.close()
            driver.switchTo().window(before)
        }
    }

    internal companion object {
        private const val POINTER_MILLISECONDS = 10L
        private const val MAX_TEXT = 1000
        private const val LISTED = "[...document.querySelectorAll('.log-table [data-path]')]"
        private var isTabTaken = false

        /** Opens [file]. */
        fun open(file: Path, screen: Screen, script: String?): OpenPage = open(file.toUri().toString(), screen, script)

        /** Opens the page at [address]. */
        fun open(address: String, screen: Screen, script: String?): OpenPage {
            val driver = Chromium.driver
            val before = if (isTabTaken) driver.windowHandle else null
            if (before != null) driver.switchTo().newWindow(WindowType.TAB)
            isTabTaken = true
            val page = OpenPage(driver, address, before)
            try {
                page.emulate(screen)
                listOfNotNull(SETTLING, script).forEach(page::runFirst)
                page.logs.forget()
                page.forgetWay()
                driver.get(address)
            } catch (e: WebDriverException) {
                page.close()
                throw e
            }
            return page
        }

        /**
         * Counts the pending work of a page, so that no step of a test depends on the machine's speed.
         *
         * `settled` ends short pauses at once, and waits for the frames, tasks and ways through the history that the page has asked for. It
         * gives up on a page that is never quiet, such as one that plays. Timers of notices that disappear by themselves and of resting
         * fingers are held until a test lets [passTime]. With `keepsTime`, all timers fire at their usual times.
         */
        private const val SETTLING = """
            (() => {
                const [set, clear, frame, cancel] = [window.setTimeout, window.clearTimeout, window.requestAnimationFrame, window.cancelAnimationFrame]
                const [held, pauses, tasks, frames] = [new Map(), new Map(), new Set(), new Set()]
                let next = 1e9
                let ways = 0
                window.keepsTime = false
                window.setTimeout = (work, delay, ...more) => {
                    const run = () => work(...more)
                    if (window.keepsTime) return set(run, delay)
                    const waiting = delay >= 500 ? held : delay > 16 ? pauses : null
                    if (waiting) {
                        const id = ++next
                        const real = waiting === held ? 0 : set(() => { pauses.delete(id); run() }, delay)
                        waiting.set(id, { run, real })
                        return id
                    }
                    const id = set(() => { tasks.delete(id); run() }, delay)
                    tasks.add(id)
                    return id
                }
                window.clearTimeout = id => {
                    clear(pauses.get(id)?.real)
                    for (const waiting of [held, pauses, tasks]) waiting.delete(id)
                    clear(id)
                }
                window.requestAnimationFrame = work => {
                    const id = frame(time => { frames.delete(id); work(time) })
                    frames.add(id)
                    return id
                }
                window.cancelAnimationFrame = id => { frames.delete(id); cancel(id) }
                for (const way of ['back', 'forward', 'go']) {
                    const real = History.prototype[way]
                    History.prototype[way] = function (...steps) { ways++; return real.apply(this, steps) }
                }
                window.addEventListener('popstate', () => { ways = 0 }, true)
                const end = waiting => {
                    const due = [...waiting.values()]
                    waiting.clear()
                    for (const { run, real } of due) { clear(real); run() }
                }
                window.passTime = () => end(held)
                window.settled = done => {
                    let [quiet, left] = [0, 60]
                    const look = () => {
                        quiet = tasks.size || frames.size || ways ? 0 : quiet + 1
                        if (quiet > 2 || left-- === 0) { ways = 0; set(done) } else frame(() => set(look))
                    }
                    set(() => { end(pauses); look() })
                }
            })()
        """

        @Suppress("UNCHECKED_CAST")
        private fun strings(result: Any?) = result as List<String>
    }
}
