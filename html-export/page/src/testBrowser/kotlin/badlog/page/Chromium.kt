package badlog.page

import badlog.core.waiting.eventually
import io.kotest.core.test.Enabled
import org.openqa.selenium.chrome.ChromeDriver
import org.openqa.selenium.chrome.ChromeDriverService
import org.openqa.selenium.chrome.ChromeOptions
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration

/** The Chromium that all page tests share, started for the first of them. */
internal object Chromium {
    private val program = onPath("chromium", "chromium-browser", "google-chrome")
    private val driverProgram = onPath("chromedriver")
    private val isRequired = System.getenv("BADLOG_BROWSER") == "required"

    /** Whether page tests can run here, otherwise the reason. It is printed once for all tests, in a line that the build passes on. */
    val enabled: Enabled by lazy {
        val missing = listOfNotNull(
            "Chromium".takeIf { program == null },
            "chromedriver".takeIf { driverProgram == null },
        )
        if (missing.isEmpty() || isRequired) {
            Enabled.enabled
        } else {
            val reason = "${missing.joinToString(" and ")} missing on the PATH"
            println("Page tests are skipped: $reason")
            Enabled.disabled(reason)
        }
    }

    /** The folder of its downloads. */
    val downloads: Path by lazy { Files.createTempDirectory("badlog-downloads") }

    /** The browser, which ends with the tests. */
    val driver: ChromeDriver by lazy(::start)

    private fun start(): ChromeDriver {
        val profile = Files.createTempDirectory("badlog-profile")
        val options = ChromeOptions().apply {
            setBinary(present(program, "Chromium").toFile())
            addArguments(
                "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
                "--disable-background-networking", "--disable-component-update", "--disable-sync",
                "--user-data-dir=$profile", "--ignore-certificate-errors-spki-list=${TestCertificate.fingerprint}",
            )
            setCapability("goog:loggingPrefs", mapOf("browser" to "ALL", "performance" to "ALL"))
            setExperimentalOption("perfLoggingPrefs", mapOf("enableNetwork" to true, "enablePage" to false))
        }
        val service = ChromeDriverService.Builder()
            .usingDriverExecutable(present(driverProgram, "chromedriver").toFile())
            .usingAnyFreePort()
            .withTimeout(PATIENCE)
            .build()
        val driver = ChromeDriver(service, options)
        driver.manage().timeouts().scriptTimeout(PATIENCE)
        driver.executeCdpCommand(
            "Browser.setDownloadBehavior",
            mapOf("behavior" to "allow", "downloadPath" to downloads.toString()),
        )
        Runtime.getRuntime().addShutdownHook(
            Thread {
                driver.quit()
                for (folder in listOf(profile, downloads)) runCatching { delete(folder) }
            },
        )
        return driver
    }

    // The browser still writes for a moment after it has reported its end.
    private fun delete(folder: Path) = eventually("$folder to be deleted") { folder.toFile().deleteRecursively() }

    private fun present(program: Path?, name: String): Path = checkNotNull(program) {
        "BADLOG_BROWSER=required, but $name is not on the PATH."
    }

    private fun onPath(vararg names: String): Path? {
        val folders = System.getenv("PATH").orEmpty().split(File.pathSeparator).filter { it.isNotEmpty() }
        return names.firstNotNullOfOrNull { name ->
            folders.flatMap { listOf(Path.of(it, name), Path.of(it, "$name.exe")) }.firstOrNull(Files::isExecutable)
        }
    }

    /** The maximum time for the driver's start, and for a script; it only serves to end a failed test. */
    private val PATIENCE: Duration = Duration.ofMinutes(2)
}
