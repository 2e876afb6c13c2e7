package badlog.lib

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import java.io.File
import java.util.concurrent.CountDownLatch
import java.util.concurrent.atomic.AtomicReference
import kotlin.concurrent.thread

/** The rows that each of the two threads logs. */
private val rows = if (System.getProperty("badlog.longTests").toBoolean()) 200_000 else 10_000

class ThreadsSpec : FunSpec({
    test("four threads publish while two log $rows rows each: no torn row, no exception, no lost final value") {
        inFolder { folder ->
            val failure = AtomicReference<Throwable>()
            val publishers = ArrayList<Publisher>()
            val published = LongArray(4)
            val file = File(folder, "threads.bag")
            BadLog.init(file.path).use { log ->
                for (i in 0..3) publishers += BadLog.createPublisher("Topic $i", "ul", DataInferMode.LAST)
                val events = BadLog.createEvents("Events")
                log.finishInitialization()

                // The rows begin when all publishers have published once; they continue until the last row.
                val publish = CountDownLatch(4)
                val logged = CountDownLatch(2)
                fun started(name: String, done: CountDownLatch, work: () -> Unit) = thread(name = name) {
                    try {
                        work()
                    } catch (thrown: Throwable) {
                        failure.set(thrown)
                    } finally {
                        done.countDown()
                    }
                }
                val publishing = List(4) { i ->
                    started("publisher $i", publish) {
                        do {
                            val next = ++published[i]
                            when (i) {
                                0 -> publishers[0].publish((next % 90_000).toDouble())
                                1 -> publishers[1].publish("text $next, \"of thread 1\"")
                                2 -> BadLog.publish("Topic 2", (next % 90_000).toDouble())
                                else -> BadLog.publish("Topic 3", "text $next, \"of thread 3\"")
                            }
                            if (i == 3 && next % 10_000 == 0L) events.event("event $next")
                            if (next == 1L) publish.countDown()
                        } while (logged.count > 0)
                    }
                }
                val logging = List(2) {
                    started("logger $it", logged) {
                        publish.await()
                        repeat(rows) { log.row() }
                    }
                }
                (publishing + logging).forEach(Thread::join)
                log.row()
                log.counters().run { listOf(rowsMissed, cellsMissed, callsIgnored) } shouldBe listOf(0, 0, 0)
            }
            failure.get() shouldBe null
            val recording = recordingIn(file)
            recording.problems.filter { it.line != null }.shouldBeEmpty()
            val last = recording.rowCount - 1
            for (i in listOf(0, 2)) recording.topics[i].samples[last] shouldBe (published[i] % 90_000).toDouble()
            for (i in listOf(1, 3)) {
                val texts = recording.topics[i].texts
                texts[texts.size - 1] shouldBe "text ${published[i]}, \"of thread $i\""
                val numbers = (0 until texts.size).map { texts[it].removePrefix("text ").substringBefore(',').toLong() }
                numbers.zipWithNext().filter { (earlier, later) -> later < earlier }.shouldBeEmpty()
            }
        }
    }
})
