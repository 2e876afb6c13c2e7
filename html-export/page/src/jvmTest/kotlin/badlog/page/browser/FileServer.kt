package badlog.page.browser

import com.sun.net.httpserver.HttpExchange
import com.sun.net.httpserver.HttpServer
import java.net.InetAddress
import java.net.InetSocketAddress
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.Executors

/** Serves the files of [folder] over HTTP to this machine. Also serves parts, which browsers need for jumps within a video. */
internal class FileServer(private val folder: Path) : AutoCloseable {
    private val threads = Executors.newCachedThreadPool()
    private val server = HttpServer.create(InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0).apply {
        createContext("/") { it.use(::answer) }
        executor = threads
        start()
    }

    /** The address of the file [name]. */
    fun addressOf(name: String): String = "http://127.0.0.1:${server.address.port}/$name"

    private fun answer(exchange: HttpExchange) {
        val file = folder.resolve(exchange.requestURI.path.removePrefix("/"))
        if (!Files.isRegularFile(file)) return exchange.sendResponseHeaders(404, -1)
        val bytes = Files.readAllBytes(file)
        val range = exchange.requestHeaders.getFirst("Range")?.let { Regex("""bytes=(\d+)-(\d*)""").matchEntire(it) }
        val from = range?.groupValues?.get(1)?.toInt() ?: 0
        val to = range?.groupValues?.get(2)?.toIntOrNull() ?: bytes.lastIndex
        exchange.responseHeaders.set("Content-Type", if (file.toString().endsWith(".html")) "text/html" else "video/webm")
        exchange.responseHeaders.set("Accept-Ranges", "bytes")
        if (range != null) exchange.responseHeaders.set("Content-Range", "bytes $from-$to/${bytes.size}")
        exchange.sendResponseHeaders(if (range == null) 200 else 206, to - from + 1L)
        exchange.responseBody.write(bytes, from, to - from + 1)
    }

    override fun close() {
        server.stop(0)
        threads.shutdownNow()
    }
}
