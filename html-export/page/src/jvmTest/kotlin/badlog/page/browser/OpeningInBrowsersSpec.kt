package badlog.page.browser

import badlog.core.bag.BagTopic
import badlog.exporter.EmptyPage
import badlog.exporter.PageNetwork
import badlog.page.SAMPLES
import badlog.page.TIME
import badlog.page.WebServer
import badlog.page.WpilibServer
import badlog.page.bagOf
import badlog.page.send
import badlog.page.withRobot
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Files
import java.util.Base64
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories
import kotlin.io.path.div
import kotlin.io.path.writeBytes

@Tags("InCheck")
internal class OpeningInChromiumSpec : OpeningInBrowsersSpec(Browser.CHROMIUM)

@Tags("InProve")
internal class OpeningInOtherBrowsersSpec : OpeningInBrowsersSpec(Browser.FIREFOX, Browser.WEBKIT)

/** The page without a log, from disk and from servers, in each browser. */
internal abstract class OpeningInBrowsersSpec(vararg browsers: Browser) : FunSpec({
    val temporary by lazy { Files.createTempDirectory("badlog-opening") }
    val bag = bagOf(listOf(TIME, BagTopic("Volts", "V")), rows = 21) { row, column -> if (column == 0) row / 10.0 else row }
    val page by lazy { (temporary / EmptyPage.NAME).also { EmptyPage().write(it) } }

    afterSpec { temporary.toFile().deleteRecursively() }

    /** Chooses files with these names and bytes, as a reader does in the browser's dialog. */
    fun BrowserTab.choose(vararg files: Pair<String, ByteArray>) {
        val made = files.joinToString { (name, bytes) ->
            "new File([Uint8Array.from(atob('${Base64.getEncoder().encodeToString(bytes)}'), c => c.charCodeAt(0))], '$name')"
        }
        evaluate(
            "(() => { const data = new DataTransfer(); for (const file of [$made]) data.items.add(file);" +
                "const input = document.querySelector('input[type=file]'); input.files = data.files; input.dispatchEvent(new Event('change')) })()",
        )
    }

    fun BrowserTab.awaitState(state: String) = await("document.documentElement.dataset.state == '$state'")

    fun BrowserTab.click(selector: String) = evaluate("document.querySelector('$selector').click()")

    fun logs() = (temporary / "logs").createDirectories().also { folder ->
        SAMPLES.resolve("qualification-42.bag").copyTo(folder / "FRC_20260307_140212_OHCL_Q42.bag", overwrite = true)
        (folder / "bench.bag").writeBytes(bag)
    }

    for (browser in browsers) {
        fun browserTest(name: String, test: BrowserTab.() -> Unit) {
            test("${browser.name}: $name").config(enabledOrReasonIf = { browser.enabled }) { browser.tab.test() }
        }

        browserTest("from disk, it opens its sample, a log, and several logs as a list with their findings") {
            open("${page.toUri()}")
            awaitState("empty")
            click("#try-sample")
            awaitState("ready")
            await("document.querySelector('.graph canvas') != null && document.documentElement.dataset.rules == 'done'")
            evaluate("document.querySelector('.incident') != null") shouldBe "true"
            click("#go-back")
            awaitState("empty")
            choose("one.bag" to bag)
            awaitState("ready")
            evaluate("document.querySelector('.page-title').textContent") shouldContain "one.bag"
            click("#go-back")
            awaitState("empty")
            choose("one.bag" to bag, "q42.bag" to Files.readAllBytes(SAMPLES.resolve("qualification-42.bag")))
            await("document.querySelector('.log-table') != null")
            await("document.querySelector('.log-table')?.textContent.includes('Browned out')")
            evaluate("document.querySelectorAll('.log-table [data-path]').length") shouldBe "2"
        }

        browserTest("from a robot's server, it lists the robot's logs and opens one") {
            withRobot(logs()) { address ->
                open(address)
                await("document.querySelectorAll('.log-table [data-path]').length == 2")
                evaluate("[...document.querySelectorAll('tbody .MATCH button')].find(b => b.textContent.endsWith('bench.bag')).click()")
                awaitState("ready")
                evaluate("document.querySelector('.page-title').textContent") shouldContain "bench.bag"
            }
        }

        browserTest("from a web site, it fetches the log in a link after a click") {
            val web = (temporary / EmptyPage.WEB_NAME).also { EmptyPage().write(it, PageNetwork.WEB) }
            WebServer { it.send(Files.readAllBytes(web), "text/html") }.use { site ->
                val host = WebServer {
                    it.responseHeaders.set("Access-Control-Allow-Origin", "*")
                    it.send(bag, "application/octet-stream")
                }
                host.use {
                    open("https://${site.host}/#url=https%3A%2F%2F${host.host}%2Ffar.bag")
                    awaitState("empty")
                    evaluate("document.querySelector('.start-offer').textContent") shouldContain host.host
                    host.asked.size shouldBe 0
                    click("#accept-offer")
                    awaitState("ready")
                    evaluate("document.querySelector('.page-title').textContent") shouldContain "far.bag"
                }
            }
        }

        browserTest("from WPILib's server, it lists the robot's logs and opens one") {
            val folder = logs()
            EmptyPage().write(folder / EmptyPage.SERVED_NAME, PageNetwork.ROBOT)
            WpilibServer(folder).use { server ->
                open(server.addressOf(EmptyPage.SERVED_NAME))
                await("document.querySelectorAll('.log-table [data-path]').length == 2")
                evaluate("[...document.querySelectorAll('tbody .MATCH button')].find(b => b.textContent.endsWith('bench.bag')).click()")
                awaitState("ready")
                evaluate("document.querySelector('.page-title').textContent") shouldContain "bench.bag"
            }
        }
    }
})
