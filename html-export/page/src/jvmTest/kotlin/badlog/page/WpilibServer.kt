package badlog.page

import com.sun.net.httpserver.HttpExchange
import com.sun.net.httpserver.HttpServer
import java.net.InetAddress
import java.net.InetSocketAddress
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.Executors
import kotlin.io.path.fileSize
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readBytes

/**
 * Serves [folder] as WPILib's `WebServer` does (2025 to 2027). It supports only GET, and answers with a folder's `index.html`, otherwise
 * with its list, as JSON on request. There are no ranges and no times of change.
 */
internal class WpilibServer(private val folder: Path) : AutoCloseable {
    private val threads = Executors.newCachedThreadPool()
    private val server = HttpServer.create(InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0).apply {
        createContext("/") { it.use(::answer) }
        executor = threads
        start()
    }

    /** The address of the file [name]. */
    fun addressOf(name: String): String = "http://127.0.0.1:${server.address.port}/$name"

    private fun answer(exchange: HttpExchange) {
        val path = folder.resolve(exchange.requestURI.path.removePrefix("/"))
        val index = path.resolve("index.html")
        when {
            exchange.requestMethod != "GET" -> send(exchange, 501, "text/plain", ByteArray(0))
            path.isRegularFile() -> send(exchange, 200, typeOf(path), path.readBytes())
            !path.isDirectory() -> send(exchange, 404, "text/plain", "not found".encodeToByteArray())
            index.isRegularFile() -> send(exchange, 200, "text/html", index.readBytes())
            exchange.requestURI.rawQuery == "format=json" -> send(exchange, 200, "application/json", listing(path).encodeToByteArray())
            else -> send(exchange, 200, "text/html", "<html><body>${path.name}</body></html>".encodeToByteArray())
        }
    }

    private fun listing(path: Path): String {
        val (folders, files) = path.listDirectoryEntries().filterNot { Files.isHidden(it) }.partition { it.isDirectory() }
        val dirs = folders.joinToString(",") { "{\"name\":\"${it.name}\"}" }
        return "{\"dirs\":[$dirs],\"files\":[${files.joinToString(",") { "{\"name\":\"${it.name}\",\"size\":${it.fileSize()}}" }}]}"
    }

    private fun typeOf(path: Path) = if (path.name.endsWith(".html")) "text/html" else "application/octet-stream"

    private fun send(exchange: HttpExchange, status: Int, type: String, bytes: ByteArray) {
        exchange.responseHeaders.set("Content-Type", type)
        exchange.responseHeaders.set("Access-Control-Allow-Origin", "*")
        exchange.responseHeaders.set("Cache-Control", "no-store")
        exchange.sendResponseHeaders(status, if (bytes.isEmpty()) -1 else bytes.size.toLong())
        exchange.responseBody.write(bytes)
    }

    override fun close() {
        server.stop(0)
        threads.shutdownNow()
    }
}
