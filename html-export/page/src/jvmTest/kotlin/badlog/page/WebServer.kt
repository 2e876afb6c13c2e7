package badlog.page

import com.sun.net.httpserver.HttpExchange
import com.sun.net.httpserver.HttpsConfigurator
import com.sun.net.httpserver.HttpsServer
import java.net.InetAddress
import java.net.InetSocketAddress
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.Executors

/** A request of the browser to a [WebServer]. */
internal class ReceivedRequest(val path: String, val cookies: String?, val referrer: String?)

/** A web site with https on this machine; [answer] answers requests. */
internal class WebServer(private val answer: (HttpExchange) -> Unit) : AutoCloseable {
    private val threads = Executors.newCachedThreadPool()
    private val server = HttpsServer.create(InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0).apply {
        httpsConfigurator = HttpsConfigurator(TestCertificate.context())
        createContext("/") { exchange ->
            exchange.use {
                val headers = it.requestHeaders
                asked += ReceivedRequest(it.requestURI.path, headers.getFirst("Cookie"), headers.getFirst("Referer"))
                answer(it)
            }
        }
        executor = threads
        start()
    }

    /** All requests, in order. */
    val asked = CopyOnWriteArrayList<ReceivedRequest>()

    val host: String get() = "127.0.0.1:${server.address.port}"

    override fun close() {
        server.stop(0)
        threads.shutdownNow()
    }
}

/** Answers with [bytes], and reports [length] as their number. */
internal fun HttpExchange.send(bytes: ByteArray, type: String = "application/octet-stream", length: Long = bytes.size.toLong(), code: Int = 200) {
    responseHeaders.set("Content-Type", type)
    sendResponseHeaders(code, length)
    responseBody.write(bytes)
}
