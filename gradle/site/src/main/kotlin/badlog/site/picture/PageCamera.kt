package badlog.site.picture

import com.sun.net.httpserver.HttpExchange
import com.sun.net.httpserver.HttpServer
import java.awt.image.BufferedImage
import java.net.InetAddress
import java.net.InetSocketAddress
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.CountDownLatch
import java.util.concurrent.Executors
import java.util.concurrent.TimeUnit
import javax.imageio.ImageIO
import kotlin.io.path.readBytes

/**
 * Takes pictures of an exported [page] in Chromium, each of [width] × [height] pixels.
 *
 * Chromium takes its picture when everything is loaded, but then the page is still reading its log. A frame around the page therefore loads
 * another file, which a local server sends only when the page is ready.
 */
internal class PageCamera(private val page: Path, private val width: Int, private val height: Int) : AutoCloseable {
    private val threads = Executors.newCachedThreadPool()
    private val server = HttpServer.create(InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0)

    @Volatile private var isReady = CountDownLatch(1)

    @Volatile private var part = ""

    init {
        server.executor = threads
        server.createContext("/frame") { answer(it, frame().toByteArray()) }
        server.createContext("/page") { answer(it, page.readBytes()) }
        server.createContext("/ready") {
            isReady.countDown()
            answer(it, ByteArray(0))
        }
        server.createContext("/wait") {
            isReady.await(WAIT_SECONDS, TimeUnit.SECONDS)
            answer(it, ByteArray(0))
        }
        server.start()
    }

    /**
     * Returns a picture of the page at [part], the part of its address from # on.
     *
     * @throws IllegalStateException if there is no Chromium, or the page does not become ready.
     */
    fun take(part: String): BufferedImage {
        isReady = CountDownLatch(1)
        this.part = part
        val folder = Files.createTempDirectory("badlog-picture")
        try {
            val file = folder.resolve("page.png")
            val program = ProcessBuilder(
                "chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                "--user-data-dir=${folder.resolve(
                    "profile",
                )}",
                "--window-size=$width,$height", "--screenshot=$file", "http://127.0.0.1:${server.address.port}/frame",
            ).redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD).start()
            val hasEnded = program.waitFor(2 * WAIT_SECONDS, TimeUnit.SECONDS)
            if (!hasEnded) program.destroyForcibly()
            check(hasEnded && Files.exists(file)) { "Chromium took no picture of $page; check that “chromium” starts." }
            check(isReady.count == 0L) { "$page was not ready after $WAIT_SECONDS s; open it in a browser to see why." }
            return ImageIO.read(file.toFile())
        } finally {
            folder.toFile().deleteRecursively()
        }
    }

    override fun close() {
        server.stop(0)
        threads.shutdownNow()
    }

    private fun frame(): String = """
        <!doctype html>
        <style>body { margin: 0 } iframe { border: 0; width: 100vw; height: 100vh; display: block } img { position: absolute; width: 0 }</style>
        <iframe src="/page$part"></iframe><img src="/wait" alt="">
        <script>
        const shown = document.querySelector("iframe");
        const timer = setInterval(() => {
          if (shown.contentDocument.documentElement.dataset.state !== "ready") return;
          clearInterval(timer);
          setTimeout(() => fetch("/ready"), $DRAW_MILLIS);
        }, 50);
        </script>
    """.trimIndent()

    private fun answer(exchange: HttpExchange, body: ByteArray) = exchange.use {
        it.responseHeaders.add("Content-Type", "text/html; charset=utf-8")
        it.sendResponseHeaders(HTTP_OK, if (body.isEmpty()) -1 else body.size.toLong())
        it.responseBody.use { out -> out.write(body) }
    }
}

private const val HTTP_OK = 200
private const val WAIT_SECONDS = 60L

/** The time after which a ready page has drawn everything, and its rules have run. */
private const val DRAW_MILLIS = 3000
