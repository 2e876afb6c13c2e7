package badlog.fetch

import org.apache.sshd.common.file.virtualfs.VirtualFileSystemFactory
import org.apache.sshd.common.keyprovider.KeyPairProvider
import org.apache.sshd.common.util.buffer.Buffer
import org.apache.sshd.server.SshServer
import org.apache.sshd.server.session.ServerSession
import org.apache.sshd.sftp.server.AbstractSftpEventListenerAdapter
import org.apache.sshd.sftp.server.FileHandle
import org.apache.sshd.sftp.server.SftpFileSystemAccessor
import org.apache.sshd.sftp.server.SftpSubsystemFactory
import org.apache.sshd.sftp.server.SftpSubsystemProxy
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.FileTime
import java.security.KeyPair
import java.security.KeyPairGenerator
import java.time.Instant
import java.time.temporal.ChronoUnit
import java.util.Collections
import java.util.concurrent.CountDownLatch
import java.util.concurrent.atomic.AtomicLong

/**
 * A robot's computer: SFTP on a free port of this one, with the files below [disk].
 *
 * @param key its host key.
 */
class FakeRobot(private val disk: Path, key: KeyPair = newKey(), private val passwords: Map<String, String> = mapOf("lvuser" to "")) : AutoCloseable {
    /** The time when it was switched on. */
    val start: Instant = Instant.now().truncatedTo(ChronoUnit.SECONDS)

    private val sftp = SftpSubsystemFactory()
    private val server = SshServer.setUpDefaultServer()
    private val served = AtomicLong()
    private val servedBySession = Collections.synchronizedMap(LinkedHashMap<ServerSession, Long>())
    private val silence = CountDownLatch(1)

    /** The number of bytes of logs after which all connections end, once. */
    @Volatile
    var endsAfter = Long.MAX_VALUE

    /** The number of bytes of logs after which it stops answering. */
    @Volatile
    var stallsAfter = Long.MAX_VALUE

    /** Called before each piece of a log is sent, with the number of bytes sent so far. */
    @Volatile
    var beforePiece: (Long) -> Unit = {}

    /** Returns the name of a file of its disk in a listing, in place of its own name. */
    @Volatile
    var nameInListing: (String) -> String = { it }

    /** The users who tried to log in. */
    val users: MutableList<String> = Collections.synchronizedList(ArrayList())

    /** The number of bytes of logs sent. */
    val servedBytes: Long get() = served.get()

    /** The numbers of bytes of logs sent over each connection that requested any, in their order. */
    val servedByConnection: List<Long> get() = synchronized(servedBySession) { servedBySession.values.toList() }

    /** The number of open connections. */
    val connections: Int get() = server.activeSessions.size

    val port: Int get() = server.port

    init {
        Files.createDirectories(disk.resolve("home/lvuser/logs"))
        sftp.addSftpEventListener(object : AbstractSftpEventListenerAdapter() {
            override fun reading(
                session: ServerSession,
                remote: String,
                file: FileHandle,
                offset: Long,
                data: ByteArray,
                at: Int,
                size: Int,
            ) = give(session, size)
        })
        sftp.fileSystemAccessor = object : SftpFileSystemAccessor {
            override fun putRemoteFileName(subsystem: SftpSubsystemProxy, path: Path?, buffer: Buffer, name: String, isShort: Boolean) {
                buffer.putString(if (isShort) nameInListing(name) else name)
            }
        }
        server.host = "127.0.0.1"
        server.keyPairProvider = KeyPairProvider.wrap(key)
        server.subsystemFactories = listOf(sftp)
        server.fileSystemFactory = VirtualFileSystemFactory(disk)
        server.setPasswordAuthenticator { user, word, _ ->
            users += user
            passwords[user] == word
        }
        server.start()
    }

    /** Writes a log named [name] with [content] to its disk, last written [secondsAgo] before its [start]. */
    fun log(name: String, content: String, secondsAgo: Long = 3600): Path = log(name, content.encodeToByteArray(), secondsAgo)

    /** Writes a log named [name] with [content] to its disk, last written [secondsAgo] before its [start]. */
    fun log(name: String, content: ByteArray, secondsAgo: Long = 3600): Path {
        val file = disk.resolve("home/lvuser/logs").resolve(name)
        Files.createDirectories(file.parent)
        Files.write(file, content)
        Files.setLastModifiedTime(file, FileTime.from(start.minusSeconds(secondsAgo)))
        return file
    }

    /** Returns its address. */
    fun address(networkTablesPort: Int = 1, name: String = "10.10.14.2"): RobotAddress = RobotAddress("127.0.0.1", listOf(Login("lvuser", ""), Login("systemcore", "systemcore")), port, networkTablesPort, name)

    private fun give(session: ServerSession, size: Int) {
        val before = served.getAndAdd(size.toLong())
        servedBySession.merge(session, size.toLong(), Long::plus)
        beforePiece(before)
        if (before >= endsAfter) {
            endsAfter = Long.MAX_VALUE
            session.close(true)
        }
        if (before >= stallsAfter) silence.await()
    }

    override fun close() {
        silence.countDown()
        server.stop(true)
    }

    companion object {
        /** Returns a host key that no other robot has. */
        fun newKey(): KeyPair = KeyPairGenerator.getInstance("EC").apply { initialize(256) }.generateKeyPair()
    }
}
