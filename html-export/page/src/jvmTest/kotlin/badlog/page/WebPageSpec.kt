package badlog.page

import badlog.core.bag.BagTopic
import badlog.exporter.EmptyPage
import badlog.exporter.PageNetwork
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.io.IOException
import java.net.URLEncoder
import java.nio.file.Files
import java.util.Base64
import kotlin.io.path.div
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeBytes

/** The page on a web site. Links name logs, and other programs hand logs over. */
@Tags("InCheck")
internal class WebPageSpec : PageSpec({
    val temporary by lazy { Files.createTempDirectory("badlog-web") }
    val page by lazy { (temporary / EmptyPage.WEB_NAME).also { EmptyPage().write(it, PageNetwork.WEB) } }
    val bag = bagOf(listOf(TIME, BagTopic("Volts", "V")), rows = 21) { row, column -> if (column == 0) row / 10.0 else row }

    afterSpec { temporary.toFile().deleteRecursively() }

    fun site() = WebServer { it.send(page.readBytes(), "text/html") }

    /** Returns a host of logs that lets any site read them, without cookies. */
    fun logs(length: Long? = null, code: Int = 200, isOpen: Boolean = true) = WebServer {
        if (isOpen) it.responseHeaders.set("Access-Control-Allow-Origin", "*")
        try {
            it.send(bag, length = length ?: bag.size.toLong(), code = code)
        } catch (_: IOException) {
            // The page has stopped reading.
        }
    }

    fun linkTo(address: String) = "#url=" + URLEncoder.encode(address, Charsets.UTF_8).replace("+", "%20")

    fun OpenPage.offers() = texts(".start-offer p")

    /** Opens the page on [site] with [fragment]. */
    fun onWeb(site: WebServer, fragment: String = "", test: OpenPage.() -> Unit) {
        OpenPage.open("https://${site.host}/index.html$fragment", Screen.WIDE, script = null).use { open ->
            open.awaitState("empty")
            open.test()
        }
    }

    test("only the page for a web site may use other servers, by https alone, and a saved copy of any page uses none") {
        val plain = (temporary / EmptyPage.NAME).also { EmptyPage().write(it) }.readText()
        val web = page.readText()
        web.replace("connect-src 'self' https:; ", "").replace(",\"network\":\"web\"", "") shouldBe plain
        plain shouldNotContain "connect-src"
    }

    browserTest("the log in a link is fetched after a click on its host, without cookies or the address of the page") {
        site().use { site ->
            logs().use { host ->
                onWeb(site, linkTo("https://${host.host}/day 1/match.bag?key=1")) {
                    offers() shouldContainExactly listOf(
                        "A link wants to open “match.bag” from ${host.host}. It is requested from that site, and from any site to which that one redirects, without cookies.",
                    )
                    keepScreenshot("web-offer")
                    seriousForReaders().shouldBeEmpty()
                    host.asked.shouldBeEmpty()
                    script("document.cookie = 'secret=1'")
                    click("#accept-offer")
                    awaitState("ready")
                    text shouldContain "match.bag"
                    texts(".notice p").single() shouldBe ""
                    script("navigator.clipboard.writeText = async text => { window.copied = text }")
                    click("#copy-link")
                    (script("return window.copied") as String) shouldContain "#url=https%3A%2F%2F"
                    host.asked.map { Triple(it.path, it.cookies, it.referrer) } shouldContainExactly listOf(Triple("/day 1/match.bag", null, null))
                    val copy = temporary / "copy.html"
                    copy.writeBytes(exported("A copy of this page, with your notes and board", "match.html"))
                    copy.readText() shouldNotContain "connect-src"
                    onPage(copy) { text shouldContain "match.bag" }
                }
            }
        }
    }

    browserTest("a failed download is explained: no such file, too large, other sites may not read it") {
        site().use { site ->
            for ((host, said) in listOf(
                logs(code = 404) to "has no such file",
                logs(length = 600_000_000) to "larger than 500 MB",
                logs(isOpen = false) to "does not let other sites read its files (CORS)",
            )) {
                onWeb(site, linkTo("https://${host.host}/match.bag")) {
                    click("#accept-offer")
                    awaitState("failed")
                    text shouldContain said
                    click("#go-back")
                    awaitState("empty")
                }
                host.close()
            }
        }
    }

    browserTest("a name in a link never becomes markup, and addresses that are not https are not offered") {
        site().use { site ->
            onWeb(site, linkTo("https://example.org/%3Cimg%20src=x%20onerror=alert(1)%3E.bag")) {
                offers().single() shouldContain "“<img src=x onerror=alert(1)>.bag” from example.org"
                elements(".start-offer img").shouldBeEmpty()
                // The page's policy would forbid it.
                script("location.hash = '#url=http://example.org/a.bag'")
                driver.navigate().refresh()
                awaitState("empty")
                offers().shouldBeEmpty()
            }
        }
    }

    /** Sends [data], an expression, like another program; returns the answers. */
    fun OpenPage.hand(data: String, origin: String = "https://scout.example"): List<*> {
        script(
            "window.frame ??= document.body.appendChild(document.createElement('iframe'));" +
                "window.answers ??= (frame.contentWindow.addEventListener('message', e => answers.push(e.data)), []);" +
                "window.dispatchEvent(new MessageEvent('message', {data: $data, origin: '$origin', source: frame.contentWindow}))",
        )
        settle()
        return script("return window.answers") as List<*>
    }

    val bytes = "Uint8Array.from(atob('${Base64.getEncoder().encodeToString(bag)}'), c => c.charCodeAt(0)).buffer"

    browserTest("a log handed over by another program is read after a click; hostile programs get nothing and show nothing") {
        site().use { site ->
            onWeb(site) {
                step("a log handed over by another program is read after a click that names its origin, and the program gets only PONG") {
                    hand("{badlog: {buffer: $bytes, fileName: 'q1.bag'}}")
                    offers() shouldContainExactly listOf("https://scout.example wants to open “q1.bag” here.")
                    hand("{badlog: {buffer: $bytes, fileName: 'other.bag'}}", "https://evil.example")
                    offers() shouldContainExactly listOf("https://scout.example wants to open “q1.bag” here.")
                    click("#accept-offer")
                    awaitState("ready")
                    text shouldContain "q1.bag"
                    // A page with a log does not answer.
                    hand("'PING'").shouldBeEmpty()
                }
                startOver("empty")
                step("hostile programs get nothing and show nothing: other data is not an offer, and names are not markup") {
                    for (data in listOf(
                        "null", "undefined", "0", "'PONG'", "[]", "{}", "{badlog: null}", "{badlog: 'x'}", "{badlog: {}}", "{badlog: {buffer: null}}",
                        "{badlog: {buffer: 'text'}}", "{badlog: {buffer: [1, 2, 3]}}", "{badlog: {buffer: {byteLength: 9}}}", "{perfetto: {buffer: $bytes}}",
                        "{badlog: {buffer: new Uint8Array(4)}}", "'PING '", "['PING']",
                    )) {
                        hand(data)
                        offers().shouldBeEmpty()
                    }
                    hand("{badlog: {buffer: $bytes, fileName: '<img src=x onerror=alert(1)>'.repeat(1000)}}", "null")
                    offers().single().length shouldBe "null wants to open “” here.".length + 100
                    elements(".start-offer img").shouldBeEmpty()
                    consoleMessages().shouldBeEmpty()
                }
            }
        }
    }

    browserTest("a real program on another site sends PING, gets PONG, and hands a log over") {
        site().use { site ->
            WebServer {
                val html = "<iframe width=900 height=700 src='https://${site.host}/index.html'></iframe><script>" +
                    "const frame = document.querySelector('iframe').contentWindow;" +
                    "addEventListener('message', e => { if (e.data === 'PONG' && e.origin === 'https://${site.host}') { window.heard = true;" +
                    "frame.postMessage({badlog: {buffer: $bytes, fileName: 'q7.bag'}}, e.origin) } });" +
                    "setInterval(() => window.heard || frame.postMessage('PING', 'https://${site.host}'), 50)</script>"
                it.send(html.encodeToByteArray(), "text/html")
            }.use { other ->
                OpenPage.open("https://${other.host}/", Screen.WIDE, script = null).use { open ->
                    val driver = Chromium.driver
                    driver.switchTo().frame(0)
                    try {
                        open.await("the offer") { open.offers().isNotEmpty() }
                        open.offers().single() shouldBe "https://${other.host} wants to open “q7.bag” here."
                        open.element("#accept-offer").click()
                        open.await("the log") { open.texts(".page-title h1").singleOrNull()?.contains("Qualification 7") == true }
                    } finally {
                        driver.switchTo().defaultContent()
                    }
                }
            }
        }
    }
})
