package badlog.page

import badlog.core.waiting.eventually
import badlog.web.LogServer
import badlog.web.LogServerOptions
import java.net.HttpURLConnection
import java.net.URI
import java.nio.file.Path

/** Starts the robot's server of [folder], and runs [test] with the address of its page. */
internal fun withRobot(folder: Path, options: LogServerOptions = LogServerOptions(), test: (String) -> Unit) {
    options.folders = listOf(folder.toFile())
    val port = freePort()
    LogServer.start(port, options).use {
        val address = "http://127.0.0.1:$port/"
        eventually("the robot's server") { isAnswering(address) }
        test(address)
    }
}

/** Returns whether the server answers. No page sends such requests, so the answer takes none of the server's two places. */
private fun isAnswering(address: String): Boolean = (URI(address).toURL().openConnection() as HttpURLConnection).apply { requestMethod = "HEAD" }.responseCode > 0
