package badlog.web

import com.sun.net.httpserver.HttpServer
import java.io.IOException
import java.net.InetSocketAddress
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.ThreadPoolExecutor
import java.util.concurrent.TimeUnit

/**
 * Shows the robot's logs in any browser in the robot's network, even on a phone. `http://10.TE.AM.2:5806/` lists them, newest first, and
 * opens them. It serves only logs, and never changes them.
 *
 * It is slow on purpose, to keep the robot's loop fast: two downloads at a time, and 1 MB/s for all of them together. While the robot is
 * enabled or connected to the field, it answers with a sentence that says so; only the last megabyte of the log that is being written can
 * be read while the robot is enabled without a field.
 *
 * It never throws: it reports a failure once on standard error, and says what to do.
 */
public class LogServer private constructor(private val port: Int, private val options: LogServerOptions) : AutoCloseable {
    private var server: HttpServer? = null
    private var isClosed = false

    /** Ends the server and its running downloads. */
    @Synchronized
    override fun close() {
        isClosed = true
        val open = server ?: return
        server = null
        open.stop(0)
        (open.executor as ThreadPoolExecutor).shutdownNow()
    }

    /** The open port; null before it is open, and if opening failed. */
    internal val openPort: Int? @Synchronized get() = server?.address?.port

    private fun open() {
        try {
            Class.forName("com.sun.net.httpserver.HttpServer")
            listen()
        } catch (_: ClassNotFoundException) {
            report("it needs the module jdk.httpserver, which this Java lacks. Fetch the logs with badlog fetch instead")
        } catch (failure: IOException) {
            report("port $port cannot be opened (${failure.message}). Use another one from 5800 to 5810 that nothing else uses")
        } catch (failure: Throwable) {
            report("$failure. Fetch the logs with badlog fetch instead")
        }
    }

    @Synchronized
    private fun listen() {
        if (isClosed) return
        // A request that is slow, or never ends, occupies a thread. The server reads these limits once, when its classes are loaded.
        for ((name, value) in LIMITS) if (System.getProperty(name) == null) System.setProperty(name, value)
        val opened = HttpServer.create(InetSocketAddress(port), 0)
        val folders = if (options.folders.isEmpty()) LogFolders(USUAL_FOLDERS, USUAL_HOMES) else LogFolders(options.folders)
        val downloads = Downloads(Pace(options.bytesPerSecond, options.clock), options.clock)
        opened.createContext("/", LogHandler(folders, options, ServedPage(), downloads))
        opened.executor = ThreadPoolExecutor(THREADS, THREADS, IDLE_SECONDS, TimeUnit.SECONDS, LinkedBlockingQueue()) { work ->
            Thread(work, "badlog web").apply {
                isDaemon = true
                priority = Thread.MIN_PRIORITY
            }
        }.apply { allowCoreThreadTimeOut(true) }
        opened.start()
        server = opened
    }

    private fun report(what: String) = System.err.println("badlog: The logs are not shown in browsers: $what.")

    public companion object {
        // Two for downloads, the others for short answers.
        private const val THREADS = 4
        private const val IDLE_SECONDS = 10L
        private val LIMITS = mapOf("sun.net.httpserver.maxReqTime" to "10", "sun.net.httpserver.maxReqHeaders" to "50")

        /**
         * Starts a server on [port] with the options that suit most robots. Teams may use the ports 5800 to 5810. Other programs use some
         * of them; 5806 is usually free.
         */
        @JvmStatic
        public fun start(port: Int): LogServer = start(port, LogServerOptions())

        /** Starts a server on [port]. Returns at once: a thread of its own opens the port, and ends with the program. */
        @JvmStatic
        public fun start(port: Int, options: LogServerOptions): LogServer {
            val server = LogServer(port, options)
            // The server's own threads are daemons because this one is.
            Thread({ server.open() }, "badlog web").apply { isDaemon = true }.start()
            return server
        }
    }
}
