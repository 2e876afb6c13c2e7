package badlog.page

import badlog.web.LogServerOptions
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.div

/** Tests of pages that a robot serves while it writes a log. */
internal abstract class RunningLogSpec(body: RunningLogSpec.() -> Unit) : PageSpec({}) {
    private val temporary by lazy { Files.createTempDirectory("badlog-live") }

    init {
        afterSpec { temporary.toFile().deleteRecursively() }
        body()
    }

    fun logs(name: String): Path = (temporary / name / "logs").createDirectories()

    /** Waits until the page has received new bytes of the log since [clearAsked], and has sent [more] requests since then. */
    fun OpenPage.awaitFetched(more: Int) = await("what is new to be fetched") {
        val sizes = "performance.getEntriesByType('resource').map(e => e.decodedBodySize)"
        number("const all = $sizes; const at = all.findIndex(size => size > 1); return at < 0 ? -1 : all.length - at - 1") >= more
    }

    fun OpenPage.clearAsked() = script("performance.clearResourceTimings()")

    fun OpenPage.isLive() = script("return document.querySelector('#live').getAttribute('aria-pressed') === 'true'") as Boolean

    fun OpenPage.awaitReady() {
        await("the log") { texts(".page-title h1").size == 1 && state == "ready" }
        await("the rules") { script("return document.documentElement.dataset.rules ?? null") != null }
    }

    fun OpenPage.openRunning(name: String = "running") {
        await("the list") { elements(".log-table").isNotEmpty() }
        openListed(name)
        awaitReady()
    }

    /** Opens the log “running” in [folder] on a robot's page, and runs [test]. */
    fun onLogIn(
        folder: Path,
        options: LogServerOptions = LogServerOptions(),
        screen: Screen = Screen.WIDE,
        says: List<String> = emptyList(),
        test: OpenPage.() -> Unit,
    ) = withRobot(folder, options) { address ->
        // A robot that already sends two logs answers like that, and is asked again.
        onServedPage(address, screen, says = says + "status of 503") {
            script("keepsTime = true")
            openRunning()
            test()
        }
    }

    /** Does the same with a log of 10 s in the folder [name]. It grows when the test lets its robot write. */
    fun onRunningLog(
        name: String,
        options: LogServerOptions = LogServerOptions(),
        screen: Screen = Screen.WIDE,
        says: List<String> = emptyList(),
        motors: Int = 4,
        test: OpenPage.(WritingRobot) -> Unit,
    ) {
        val robot = WritingRobot(logs(name) / "running.bag", motors).apply { write(500) }
        onLogIn(robot.file.parent, options, screen, says) { test(robot) }
    }

    /** Does the same on a page that follows the log. */
    fun onFollowedLog(
        name: String,
        options: LogServerOptions = LogServerOptions(),
        says: List<String> = emptyList(),
        test: OpenPage.(WritingRobot) -> Unit,
    ) = onRunningLog(name, options, says = says) { robot ->
        element("#live").click()
        test(robot)
    }
}
