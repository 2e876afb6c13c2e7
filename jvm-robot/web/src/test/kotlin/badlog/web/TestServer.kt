package badlog.web

import badlog.core.waiting.eventually
import io.kotest.core.test.Enabled
import java.io.ByteArrayOutputStream
import java.io.DataInputStream
import java.io.EOFException
import java.io.File
import java.io.InputStream
import java.net.InetAddress
import java.net.Socket
import java.net.SocketException
import java.nio.file.Files
import java.nio.file.Path

/** Runs tests only on Unix. Windows lets only administrators create links, and forbids file names that other systems allow. */
internal val IF_UNIX: Enabled = if (File.separatorChar == '/') Enabled.enabled else Enabled.disabled("Windows has no such files")

/** Repeats [question] until its result is not null; fails after a minute. */
internal fun <T : Any> awaited(what: String, question: () -> T?): T {
    var answer: T? = null
    eventually(what) {
        answer = question()
        answer != null
    }
    return checkNotNull(answer)
}

/** Runs [test] with the folder `logs` and a server of it, which ends afterwards. */
internal fun withServer(options: LogServerOptions = LogServerOptions(), test: (TestServer) -> Unit) {
    val above = Files.createTempDirectory("badlog-web")
    val logs = Files.createDirectory(above.resolve("logs"))
    options.folders = listOf(logs.toFile())
    if (options.bytesPerSecond == 1_000_000L) options.bytesPerSecond = Long.MAX_VALUE / 1_000_000_000
    try {
        LogServer.start(0, options).use { server -> test(TestServer(logs, awaited("the port") { server.openPort })) }
    } finally {
        above.toFile().deleteRecursively()
    }
}

/** A server of the folder [logs] on [port]. */
internal class TestServer(val logs: Path, val port: Int) {
    fun connect() = Socket(InetAddress.getLoopbackAddress(), port).apply { soTimeout = 30_000 }

    /** Sends [head] unchanged, and returns the answer; null if the connection was closed without one. */
    fun sent(head: String): Answer? = connect().use { socket ->
        socket.getOutputStream().write(head.toByteArray(Charsets.ISO_8859_1))
        Answer.read(socket.getInputStream())
    }

    /** Requests [address], with these [headers] besides the host. */
    fun get(address: String, vararg headers: String): Answer = checkNotNull(sent((listOf("GET $address HTTP/1.1", "Host: 10.10.14.2:5806") + headers).joinToString("\r\n", postfix = "\r\n\r\n")))
}

/** An HTTP answer; [isWhole] tells whether all of the announced body came. */
internal class Answer(val status: Int, val headers: Map<String, String>, val body: ByteArray, val isWhole: Boolean) {
    val text: String get() = body.decodeToString()

    companion object {
        fun read(stream: InputStream): Answer? {
            val lines = DataInputStream(stream).let { input -> generateSequence { line(input) }.takeWhile { it.isNotEmpty() }.toList() }
            if (lines.isEmpty()) return null
            val headers = lines.drop(1).associate { it.substringBefore(':').lowercase() to it.substringAfter(':').trim() }
            val length = headers["content-length"]?.toInt() ?: 0
            val status = lines[0].split(' ')[1].toInt()
            val body = if (status == 304) ByteArray(0) else stream.readNBytes(length)
            return Answer(status, headers, body, body.size == length)
        }

        private fun line(input: DataInputStream): String? {
            val bytes = ByteArrayOutputStream()
            try {
                while (true) {
                    val byte = input.readByte().toInt()
                    if (byte == '\n'.code) return bytes.toString(Charsets.ISO_8859_1).trimEnd('\r')
                    bytes.write(byte)
                }
            } catch (_: EOFException) {
                return null
            } catch (_: SocketException) {
                return null
            }
        }
    }
}
