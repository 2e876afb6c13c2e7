package badlog.page

import badlog.web.LogServer
import badlog.web.LogServerOptions
import java.net.ConnectException
import java.net.HttpURLConnection
import java.net.URI
import java.nio.file.Path

/** Starts the robot's server of [folder], and does [test] with the address of its page. */
internal fun withRobot(folder: Path, options: LogServerOptions = LogServerOptions(), test: (String) -> Unit) {
    options.folders = listOf(folder.toFile())
    val port = freePort()
    LogServer.start(port, options).use {
        val address = "http://127.0.0.1:$port/"
        val end = System.nanoTime() + 60_000_000_000
        while (!isAnswering(address)) {
            check(System.nanoTime() < end) { "The server did not start." }
            Thread.sleep(5)
        }
        test(address)
    }
}

private fun isAnswering(address: String): Boolean = try {
    (URI(address).toURL().openConnection() as HttpURLConnection).responseCode > 0
} catch (_: ConnectException) {
    false
}
