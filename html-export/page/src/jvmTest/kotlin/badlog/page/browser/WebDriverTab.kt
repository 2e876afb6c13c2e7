package badlog.page.browser

import org.openqa.selenium.OutputType
import org.openqa.selenium.interactions.Sequence
import org.openqa.selenium.remote.RemoteWebDriver

/** A tab over WebDriver. Its [driver] stays open when the tab is closed, unless [onClose] ends it. */
internal class WebDriverTab(private val driver: RemoteWebDriver, private val onClose: () -> Unit) : BrowserTab {
    override fun open(address: String) {
        // A change of only the part after # loads nothing.
        driver.get("about:blank")
        driver.get(address)
    }

    override fun evaluate(expression: String): String = driver.executeAsyncScript(
        "const done = arguments[arguments.length - 1]; (async () => String(await ($expression)))().then(done, problem => done('failed: ' + problem))",
    ) as String

    override fun perform(sequences: List<Sequence>) = driver.perform(sequences)

    override fun screenshot(): ByteArray = driver.getScreenshotAs(OutputType.BYTES)

    override fun close() = onClose()
}
