package badlog.fetch

import java.io.IOException
import java.net.InetSocketAddress
import java.net.Socket
import java.time.Duration
import java.util.concurrent.ExecutionException
import java.util.concurrent.Future
import java.util.concurrent.FutureTask
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/**
 * Returns the [addresses] at which a program answers, in order. Each is returned as soon as no earlier one can still answer. All are tried
 * at the same time, because most do not exist on the computer's network and never answer.
 */
fun answering(addresses: List<RobotAddress>, patience: Duration): Sequence<RobotAddress> = sequence {
    val end = System.nanoTime() + patience.toNanos()
    val answers = addresses.map { address -> trying(address, patience) }
    for ((index, answer) in answers.withIndex()) if (isTrue(answer, end)) yield(addresses[index])
}

// Runs on a separate thread, which ends with the answer. A caller that has found a robot stops waiting, but does not cancel the others.
private fun trying(address: RobotAddress, patience: Duration): Future<Boolean> {
    val answer = FutureTask { answers(address, patience) }
    Thread(answer, "robot search").apply { isDaemon = true }.start()
    return answer
}

private fun isTrue(answer: Future<Boolean>, end: Long): Boolean = try {
    answer.get(maxOf(end - System.nanoTime(), 0), TimeUnit.NANOSECONDS)
} catch (_: TimeoutException) {
    // Looking up a name may take too long.
    false
} catch (_: ExecutionException) {
    false
}

private fun answers(address: RobotAddress, patience: Duration): Boolean = try {
    Socket().use { it.connect(InetSocketAddress(address.host, address.port), patience.toMillis().toInt()) }
    true
} catch (_: IOException) {
    false
}
