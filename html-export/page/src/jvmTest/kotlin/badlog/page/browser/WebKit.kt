package badlog.page.browser

import badlog.core.waiting.eventually
import badlog.page.freePort
import org.openqa.selenium.Dimension
import org.openqa.selenium.ImmutableCapabilities
import org.openqa.selenium.remote.RemoteWebDriver
import java.net.InetAddress
import java.net.Socket
import java.net.URI
import java.nio.file.Path
import java.time.Duration

internal const val WEBKIT_PROGRAM = "WebKitWebDriver"

/** Starts WebKitGTK's own browser on the screen in DISPLAY. */
internal fun webKitTab(downloads: Path): BrowserTab {
    val port = freePort()
    val service = program(WEBKIT_PROGRAM, "--port=$port").redirectError(ProcessBuilder.Redirect.DISCARD)
        .apply {
            // Without a configured folder, downloads go to this one.
            environment()["HOME"] = "$downloads"
            environment()["XDG_CONFIG_HOME"] = "$downloads/config"
        }
        .start()
    eventually("$WEBKIT_PROGRAM to listen") {
        if (service.isAlive) Socket(InetAddress.getLoopbackAddress(), port).close()
        true
    }
    check(service.isAlive) { "$WEBKIT_PROGRAM ended by itself, with code ${service.exitValue()}." }
    // The tests' servers have their own certificates.
    val wanted = ImmutableCapabilities("browserName", "MiniBrowser", "acceptInsecureCerts", true)
    val driver = RemoteWebDriver(URI("http://127.0.0.1:$port").toURL(), wanted, false)
    driver.manage().timeouts().scriptTimeout(Duration.ofMinutes(2))
    driver.manage().window().size = Dimension(1280, 940)
    return WebDriverTab(driver) {
        driver.quit()
        service.end()
    }
}
