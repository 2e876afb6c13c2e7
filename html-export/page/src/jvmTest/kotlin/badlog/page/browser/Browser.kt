package badlog.page.browser

import badlog.page.Chromium
import io.kotest.core.test.Enabled
import java.nio.file.Files
import java.nio.file.Path

/** A browser in which pages must work. */
internal enum class Browser(private vararg val programs: String) {
    CHROMIUM("chromium", "chromedriver") {
        override val downloads: Path get() = Chromium.downloads

        override fun start() = WebDriverTab(Chromium.driver) {}
    },
    FIREFOX(FIREFOX_PROGRAM) {
        override fun start() = firefoxTab(folder.resolve("profile"), downloads)
    },
    WEBKIT(WEBKIT_PROGRAM) {
        override fun start() = webKitTab(downloads)
    },
    ;

    protected val folder: Path by lazy { Files.createTempDirectory("badlog-browser") }

    /** The folder of its downloads. */
    open val downloads: Path by lazy { Files.createDirectories(folder.resolve("downloads")) }

    /** The tab that all tests share; it is closed after them. */
    val tab: BrowserTab by lazy {
        start().also { tab ->
            Runtime.getRuntime().addShutdownHook(
                Thread {
                    tab.close()
                    folder.toFile().deleteRecursively()
                },
            )
        }
    }

    /** Whether the browser is installed; otherwise the reason for skipping its tests. */
    val enabled: Enabled by lazy {
        val missing = programs.filter { onPath(it) == null }
        if (missing.isEmpty() || System.getenv("BADLOG_BROWSER") == "required") {
            Enabled.enabled
        } else {
            Enabled.disabled("Page tests are skipped: ${missing.joinToString(" and ")} missing on the PATH")
        }
    }

    protected abstract fun start(): BrowserTab
}
