package badlog.web

import com.sun.net.httpserver.Headers
import com.sun.net.httpserver.HttpExchange
import com.sun.net.httpserver.HttpHandler
import java.io.IOException
import java.nio.channels.Channels
import java.nio.channels.FileChannel
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.StandardOpenOption.READ

/** Answers the requests of [LogServer]: the page at `/`, listings with `?format=json`, and the logs in [folders]. */
internal class LogHandler(
    private val folders: LogFolders,
    private val options: LogServerOptions,
    private val page: ServedPage,
    private val downloads: Downloads,
) : HttpHandler {
    private val mayGoOn = { refusal() == null }

    // On the field, there is no exception.
    private val mayFollow = { refusal() != Refusal.FIELD }

    override fun handle(exchange: HttpExchange) {
        try {
            answer(exchange)
        } catch (_: IOException) {
            // The client is gone, or gets fewer bytes than announced, so that no browser takes them for the whole log.
        } catch (_: InterruptedException) {
            // Another request needed the place of this download, which stood still.
        } finally {
            exchange.close()
        }
    }

    private fun answer(exchange: HttpExchange) {
        with(exchange.responseHeaders) {
            add("X-Content-Type-Options", "nosniff")
            add("X-Frame-Options", "DENY")
            add("Cross-Origin-Resource-Policy", "same-origin")
            add("Cache-Control", "no-cache")
        }
        val hosts = exchange.requestHeaders["Host"].orEmpty()
        val address = exchange.requestURI.rawPath.orEmpty()
        val refusal = refusal()
        when {
            hosts.size != 1 || !isOwnHost(hosts[0]) -> refuse(exchange, Refusal.HOST)

            exchange.requestMethod != "GET" -> refuse(exchange, Refusal.METHOD)

            refusal == Refusal.FIELD -> refuse(exchange, refusal)

            address.endsWith("/") && exchange.requestURI.rawQuery == "format=json" ->
                if (refusal == null) list(exchange, address) else refuse(exchange, refusal)

            address == "/" -> if (refusal == null) sendPage(exchange) else refuse(exchange, refusal)

            else -> sendLog(exchange, address, refusal)
        }
    }

    private fun refusal(): Refusal? = when {
        options.isAlwaysOpen -> null
        options.isFieldAttached.asBoolean -> Refusal.FIELD
        options.isEnabled.asBoolean -> Refusal.ENABLED
        else -> null
    }

    private fun list(exchange: HttpExchange, address: String) {
        val listing = folders.list(address) ?: return refuse(exchange, Refusal.MISSING)
        exchange.responseHeaders["Content-Type"] = "application/json"
        exchange.responseHeaders["Cache-Control"] = "no-store"
        val bytes = listing.toJson().encodeToByteArray()
        exchange.sendResponseHeaders(OK, bytes.size.toLong())
        exchange.responseBody.write(bytes)
    }

    private fun sendPage(exchange: HttpExchange) {
        if (isKnown(exchange, page.tag)) return
        downloads.take().use { download ->
            if (download == null) return refuse(exchange, Refusal.BUSY)
            exchange.responseHeaders["Content-Type"] = "text/html; charset=utf-8"
            exchange.responseHeaders["Content-Encoding"] = "gzip"
            exchange.sendResponseHeaders(OK, page.size)
            page.open().use { download.copy(Channels.newChannel(it), page.size, exchange.responseBody, mayGoOn) }
        }
    }

    private fun sendLog(exchange: HttpExchange, address: String, refusal: Refusal?) {
        val log = folders.log(address) ?: return refuse(exchange, Refusal.MISSING)
        exchange.responseHeaders["Accept-Ranges"] = "bytes"
        val range = rangeOf(exchange, log)
        val isFollowed = refusal != null && isEnd(log, range)
        when {
            refusal != null && !isFollowed -> refuse(exchange, if (isRunning(log) && (range?.from ?: 0) > 0) Refusal.BEHIND else refusal)

            range == null && isKnown(exchange, log.tag) -> Unit

            range?.length == 0L -> {
                exchange.responseHeaders["Content-Range"] = "bytes */${log.size}"
                refuse(exchange, Refusal.RANGE)
            }

            else -> send(exchange, log, range, if (isFollowed) mayFollow else mayGoOn)
        }
    }

    private fun rangeOf(exchange: HttpExchange, log: ListedFile): ByteRange? {
        val before = exchange.requestHeaders.getFirst("If-Range")
        return if (before == null || before == log.tag) ByteRange.of(exchange.requestHeaders.getFirst("Range"), log.size) else null
    }

    /** Returns whether [range] is at the end of a log that is being written. */
    private fun isEnd(log: ListedFile, range: ByteRange?) = range != null && log.size - range.from <= TAIL_BYTES && isRunning(log)

    private fun isRunning(log: ListedFile) = System.currentTimeMillis() - log.modified < RUNNING_MILLIS

    private fun send(exchange: HttpExchange, log: ListedFile, range: ByteRange?, mayGoOn: () -> Boolean) {
        val from = range?.from ?: 0
        val length = range?.length ?: log.size
        downloads.take().use { download ->
            if (download == null) return refuse(exchange, Refusal.BUSY)
            val channel = try {
                FileChannel.open(log.path, READ, NOFOLLOW_LINKS).position(from)
            } catch (_: IOException) {
                return refuse(exchange, Refusal.UNREADABLE)
            }
            channel.use {
                exchange.responseHeaders["ETag"] = log.tag
                exchange.responseHeaders["Content-Type"] = "application/octet-stream"
                if (range != null) exchange.responseHeaders["Content-Range"] = "bytes $from-${from + length - 1}/${log.size}"
                // The length -1 announces an empty body.
                exchange.sendResponseHeaders(if (range == null) OK else PARTIAL, if (length == 0L) NO_BODY else length)
                download.copy(it, length, exchange.responseBody, mayGoOn)
            }
        }
    }

    /** Answers that nothing has changed if the client already has [tag]. */
    private fun isKnown(exchange: HttpExchange, tag: String): Boolean {
        exchange.responseHeaders["ETag"] = tag
        if (exchange.requestHeaders.getFirst("If-None-Match") != tag) return false
        exchange.sendResponseHeaders(NOT_MODIFIED, NO_BODY)
        return true
    }

    private fun refuse(exchange: HttpExchange, why: Refusal) {
        if (why == Refusal.METHOD) exchange.responseHeaders["Allow"] = "GET"
        if (why == Refusal.BUSY) exchange.responseHeaders["Retry-After"] = "1"
        exchange.responseHeaders["Content-Type"] = "text/plain; charset=utf-8"
        exchange.responseHeaders["Cache-Control"] = "no-store"
        val bytes = (why.text + "\n").encodeToByteArray()
        val hasBody = exchange.requestMethod != "HEAD"
        exchange.sendResponseHeaders(why.status, if (hasBody) bytes.size.toLong() else NO_BODY)
        if (hasBody) exchange.responseBody.write(bytes)
    }

    private operator fun Headers.set(name: String, value: String) = set(name, value)
}

private const val OK = 200
private const val PARTIAL = 206
private const val NOT_MODIFIED = 304
private const val NO_BODY = -1L

/**
 * The number of bytes at the end of a running log that may be read while the robot is enabled. That is half a minute of a log with
 * fifty numbers per loop.
 */
private const val TAIL_BYTES = 1024 * 1024

/** The maximum time since the last write of a running log. */
private const val RUNNING_MILLIS = 10_000
