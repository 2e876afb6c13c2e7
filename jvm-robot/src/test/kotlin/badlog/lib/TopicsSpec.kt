package badlog.lib

import badlog.core.recording.ProblemKind
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.longs.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import java.io.File

class TopicsSpec : FunSpec({
    test("an update consumes published data, and the last value counts") {
        inFolder { folder ->
            val file = logged(folder, {
                BadLog.createTopicSubscriber("Default", "ul", DataInferMode.DEFAULT)
                BadLog.createTopicSubscriber("Last", "ul", DataInferMode.LAST)
            }) { log ->
                log.row()
                for (name in listOf("Default", "Last")) {
                    BadLog.publish(name, 1.0)
                    BadLog.publish(name, 2.0)
                }
                log.row()
                log.log()
                log.row()
                BadLog.publish("Default", "text")
                BadLog.publish("Last", "3")
                log.updateTopics()
                log.row()
            }
            rowsIn(file) shouldBe listOf("-1.0,-1.0", "2.0000,2.0000", "2.0000,2.0000", "-1.0,2.0000", "-1.0,3")
        }
    }

    test("the additional creators make topics of their types") {
        inFolder { folder ->
            var publisher: Publisher? = null
            val file = logged(folder, {
                BadLog.createTopicDouble("Double", "V", { 1.5 }, "hide")
                BadLog.createTopicLong("Long", "ul", { 1234567890123 })
                BadLog.createTopicBoolean("Boolean", "ul", { true })
                publisher = BadLog.createPublisher("Handle", "A", DataInferMode.LAST, "join:X")
            }) { log ->
                publisher?.publish(2.5)
                log.row()
                publisher?.publish("on, off")
                publisher?.publish(null)
                log.row()
                log.setDoubleToStringFunction { "0.5" }
                log.row()
            }
            rowsIn(file) shouldBe listOf(
                "1.5000,1234567890123,true,2.5000",
                "1.5000,1234567890123,true,\"on, off\"",
                "0.5,1234567890123,true,\"on, off\"",
            )
            recordingIn(file).run {
                problems.map { it.kind } shouldBe listOf(ProblemKind.TRUTH_VALUES)
                topics.map { it.unit to it.attributes } shouldBe
                    listOf("V" to listOf("hide"), "ul" to listOf(), "ul" to listOf(), "A" to listOf("join:X"))
            }
        }
    }

    test("all events of a row are kept, whatever is updated in between") {
        inFolder { folder ->
            var events: Events? = null
            val file = logged(folder, {
                BadLog.createTopic("Time", "s", { 1.0 })
                events = BadLog.createEvents("Events")
            }) { log ->
                events?.event("early")
                log.row()
                events?.event("enabled")
                log.updateTopics()
                events?.event("auto: \"left\"")
                log.updateTopics()
                log.log()
                log.row()
                events?.event("42")
                log.row()
                standardErrorOf {
                    events?.event(null)
                    events?.event(" ")
                }
                log.row()
                log.counters().callsIgnored shouldBe 2
            }
            rowsIn(file) shouldBe listOf(
                "1.0000,early",
                "1.0000,\"enabled; auto: \"\"left\"\"\"",
                "1.0000,",
                "1.0000,event 42",
                "1.0000,\"The event log \"\"Events\"\" was given an event without a text.\"",
            )
            recordingIn(file).topics[1].run {
                attributes shouldBe listOf("log")
                texts.size shouldBe 4
            }
        }
    }

    test("events without a row do not fill the memory") {
        inFolder { folder ->
            var events: Events? = null
            logged(folder, { events = BadLog.createEvents("Events") }) { log ->
                repeat(10_000) { events?.event("event number $it") }
                log.row()
                log.counters().eventsDropped shouldBeGreaterThan 9000
            }
        }
    }

    test("without flushing, rows are written together, by flush() and by close()") {
        inFolder { folder ->
            val file = File(folder, "a.bag")
            val log = BadLog.init(file.path, false, LogSession(flushesEachRow = false, TestTime()))
            BadLog.createTopic("A", "ul", { 1.0 })
            log.finishInitialization()
            repeat(3) { log.row() }
            rowsIn(file).size shouldBe 0
            log.flush()
            rowsIn(file).size shouldBe 3
            log.row()
            log.close()
            rowsIn(file).size shouldBe 4
            log.counters().rowsWritten shouldBe 4
            log.counters().bytesWritten shouldBe file.length()
        }
    }

    test("without flushing, a row waits at most a quarter of a second while others come") {
        inFolder { folder ->
            val file = File(folder, "a.bag")
            val time = TestTime()
            BadLog.init(file.path, false, LogSession(flushesEachRow = false, time)).use { log ->
                BadLog.createTopic("A", "ul", { 1.0 })
                log.finishInitialization()
                log.row()
                time.stall(249)
                log.row()
                rowsIn(file).size shouldBe 0
                time.stall(1)
                log.row()
                rowsIn(file).size shouldBe 3
            }
        }
    }

    test("without flushing, a row is also written if no other follows") {
        inFolder { folder ->
            val file = File(folder, "a.bag")
            val time = TestTime()
            BadLog.init(file.path, false, LogSession(flushesEachRow = false, time)).use { log ->
                BadLog.createTopic("A", "ul", { 1.0 })
                log.finishInitialization()
                log.row()
                time.pass(249)
                rowsIn(file).size shouldBe 0
                time.pass(1)
                rowsIn(file).size shouldBe 1
            }
        }
    }

    test("the syncing thread is a daemon that ends with its log, and looks for the file without syncing, too")
        .config(enabledOrReasonIf = { IF_OPEN_FILES_GO }) {
            inFolder { folder ->
                val time = TestTime()
                val log = BadLog.init(File(folder, "a.bag").path, false, LogSession(flushesEachRow = true, time))
                log.finishInitialization()
                log.setSyncing(false)
                time.settle()
                val syncing = time.threads.single()
                syncing.isDaemon shouldBe true
                standardErrorOf {
                    File(folder, "a.bag").delete()
                    time.pass(500)
                    log.state shouldBe LogState.FAILING
                }
                syncing.isAlive shouldBe true
                log.close()
                time.awaitEnd()
            }
        }
})
