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
 * Those of [addresses] at which something answers, in their order, each as soon as no earlier one can. All are tried at the same
 * time: most do not exist in the network that the computer is in, and say nothing.
 */
public fun answering(addresses: List<RobotAddress>, patience: Duration): Sequence<RobotAddress> = sequence {
    val end = System.nanoTime() + patience.toNanos()
    val answers = addresses.map { address -> trying(address, patience) }
    for ((index, answer) in answers.withIndex()) if (isTrue(answer, end)) yield(addresses[index])
}

// On a thread of its own, which ends with the answer: whoever has found a robot asks no further, and ends nothing.
private fun trying(address: RobotAddress, patience: Duration): Future<Boolean> {
    val answer = FutureTask { answers(address, patience) }
    Thread(answer, "robot search").apply { isDaemon = true }.start()
    return answer
}

private fun isTrue(answer: Future<Boolean>, end: Long): Boolean = try {
    answer.get(maxOf(end - System.nanoTime(), 0), TimeUnit.NANOSECONDS)
} catch (_: TimeoutException) {
    // Looking up a name may take longer than anybody waits.
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
