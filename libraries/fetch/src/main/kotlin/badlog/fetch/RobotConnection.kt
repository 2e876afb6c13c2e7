package badlog.fetch

import badlog.core.recording.RecordingFormat
import badlog.files.LogName
import org.apache.sshd.client.session.ClientSession
import org.apache.sshd.sftp.client.SftpClient
import org.apache.sshd.sftp.client.SftpClient.OpenMode
import org.apache.sshd.sftp.client.SftpClientFactory
import org.apache.sshd.sftp.common.SftpConstants
import org.apache.sshd.sftp.common.SftpException
import java.io.IOException
import java.io.InputStream
import java.io.InterruptedIOException
import java.net.SocketTimeoutException
import java.nio.channels.ClosedByInterruptException
import kotlin.math.min

/**
 * A connection to a robot after login. All network errors are [IOException]s. Must be closed.
 *
 * @property address the address of the robot.
 * @property user the user that was accepted.
 * @property robot identifies the robot regardless of its address: the fingerprint of its host key.
 */
internal class RobotConnection(val address: RobotAddress, val user: String, val robot: String, private val session: ClientSession) :
    AutoCloseable {
    private val sftp: SftpClient = talking { SftpClientFactory.instance().createSftpClient(session) }

    /**
     * Returns the logs in and below those [folders] that exist. Also returns the bags directly in [homes], which contain other files, too.
     */
    fun list(folders: List<String>, homes: List<String> = emptyList()): RemoteListing = talking {
        val found = LinkedHashSet<String>()
        for (folder in folders) realPath(folder)?.let(found::add)
        val bare = homes.mapNotNull(::realPath).toSet() - found
        val logs = ArrayList<RemoteLog>()
        val refused = ArrayList<String>()
        val left = ArrayDeque(found.map { it to 0 } + bare.map { it to MAX_DEPTH })
        while (left.isNotEmpty()) {
            val (folder, depth) = left.removeFirst()
            for (entry in sftp.readDir(folder)) {
                val name = entry.filename
                val attributes = entry.attributes
                when {
                    name == "." || name == ".." || logs.size >= MAX_LOGS -> continue

                    !isInFolder(name) -> refused += name

                    attributes.isDirectory && depth < MAX_DEPTH && !name.startsWith(".") ->
                        left += "${folder.trimEnd('/')}/$name" to depth + 1

                    attributes.isRegularFile && if (folder in bare) isBag(name) else isLog(name) ->
                        logs += RemoteLog(folder, name, attributes.size, attributes.modifyTime?.toMillis()?.div(MILLIS) ?: 0)
                }
            }
        }
        RemoteListing(logs, refused, found.toList())
    }

    /** Returns the current state of [log]; null if it is gone. */
    fun look(log: RemoteLog): RemoteLog? = talking {
        try {
            val now = sftp.stat(log.path)
            log.copy(size = now.size, modified = now.modifyTime?.toMillis()?.div(MILLIS) ?: 0)
        } catch (e: SftpException) {
            if (e.status == SftpConstants.SSH_FX_NO_SUCH_FILE) null else throw e
        }
    }

    /** Returns the bytes of [log] starting at [from]; many are requested at a time. The stream throws the same exceptions as [talking]. */
    fun read(log: RemoteLog, from: Long): InputStream = talking {
        sftp.read(log.path, OpenMode.Read).also { if (from > 0) it.skip(from) }
    }

    /** Returns [size] bytes of [log] starting at [from], or fewer if the log ends before that. */
    fun piece(log: RemoteLog, from: Long, size: Int): ByteArray = talking {
        val bytes = ByteArray(size)
        var done = 0
        sftp.open(log.path, OpenMode.Read).use { handle ->
            while (done < size) {
                val read = sftp.read(handle, from + done, bytes, done, min(size - done, PIECE))
                if (read <= 0) break
                done += read
            }
        }
        bytes.copyOf(done)
    }

    /** Removes [log] from the robot. */
    fun remove(log: RemoteLog): Unit = talking { sftp.remove(log.path) }

    override fun close() {
        session.close(true)
    }

    // A folder may have several names, such as /u and /U, or a link.
    private fun realPath(folder: String): String? = try {
        sftp.canonicalPath(folder).takeIf { sftp.stat(it).isDirectory }
    } catch (_: SftpException) {
        null
    }

    companion object {
        /**
         * Runs [work], which communicates with a robot.
         *
         * @throws InterruptedException if the thread was interrupted.
         */
        fun <T> talking(work: () -> T): T = try {
            work()
        } catch (e: IOException) {
            throw if (isInterruption(e)) InterruptedException() else e
        }

        /** Returns whether [e] means that the thread was interrupted, possibly wrapped by the SSH library. */
        fun isInterruption(e: IOException): Boolean = generateSequence<Throwable>(e) { it.cause }.any {
            // In Java, a timeout is also an interruption.
            it is InterruptedException || it is ClosedByInterruptException ||
                (it is InterruptedIOException && it !is SocketTimeoutException)
        }

        private fun isLog(name: String) = !name.startsWith(".") && LogName.of(name).mayBeLog && !name.endsWith(".tar.gz", ignoreCase = true)

        private fun isBag(name: String) = isLog(name) && LogName.of(name).ending.lowercase() in RecordingFormat.BAG.endings

        private fun isInFolder(name: String) = name.isNotEmpty() && '/' !in name && '\u0000' !in name

        private const val MILLIS = 1000
        private const val PIECE = 16_384

        /** The maximum depth of folders; no robot's logs are nested deeper. */
        private const val MAX_DEPTH = 4

        /** The maximum number of logs; no robot has more. */
        private const val MAX_LOGS = 100_000
    }
}
