package badlog.lib

import badlog.core.recording.Severity
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.longs.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.File
import java.io.IOException

/** The pause after which a full disk is tried again. */
private const val RETRY_MILLIS = 250L

/** The time between two checks for a deleted file; it is noticed at the second one. */
private const val LOOK_MILLIS = 250L

/** Runs tests only where a device exists that is always full. */
private val IF_FULL =
    if (File.separatorChar == '/') Enabled.enabled else Enabled.disabled("Windows has no device that is always full")

class DiskTroubleSpec : FunSpec({
    for (compress in listOf(false, true)) {
        test("a full disk loses rows and nothing else" + if (compress) ", compressed" else "")
            .config(enabledOrReasonIf = { ifMount() }) {
                onSmallDisk { disk ->
                    val filler = File(disk, "filler")
                    val file = File(disk, if (compress) "full.bag.gz" else "full.bag")
                    val time = TestTime()
                    val messages = standardErrorOf {
                        BadLog.init("$disk/full.bag", compress, LogSession(flushesEachRow = true, time)).use { log ->
                            createTopics()
                            log.finishInitialization()
                            repeat(50) { log.row() }
                            fill(filler)
                            repeat(2000) { log.row() }
                            log.state shouldBe LogState.FAILING
                            filler.delete()
                            time.pass(RETRY_MILLIS - 1)
                            log.row()
                            log.state shouldBe LogState.FAILING
                            time.pass(1)
                            log.row()
                            log.state shouldBe LogState.LOGGING
                            repeat(50) { log.row() }
                            log.state shouldBe LogState.LOGGING
                            val counters = log.counters()
                            counters.rowsMissed shouldBeGreaterThan 0
                            counters.rowsWritten + counters.rowsMissed shouldBe 2102
                            counters.bytesWritten shouldBe file.length()
                        }
                    }
                    messages.trim().lines().size shouldBe 1
                    messages shouldContain "No space left"
                    val recording = recordingIn(if (compress) inflated(file.readBytes()) else file.readBytes())
                    recording.problems.filter { it.severity == Severity.ERROR }.shouldBeEmpty()
                    recording.topics[0].samples.run { last() } shouldBe 2102.0
                    val events = recording.topics.last().texts.dictionary
                    events.first() shouldContain "cannot be written"
                    events.last() shouldContain "could not be written"
                }
            }
    }

    test("events that happen while the disk is full are written later").config(enabledOrReasonIf = { ifMount() }) {
        onSmallDisk { disk ->
            val filler = File(disk, "filler")
            val time = TestTime()
            standardErrorOf {
                BadLog.init("$disk/events.bag", false, LogSession(flushesEachRow = true, time)).use { log ->
                    val events = BadLog.createEvents("Events")
                    log.finishInitialization()
                    log.row()
                    fill(filler)
                    // Fills the rest of the page that the file already has.
                    while (log.state == LogState.LOGGING) {
                        events.event("filling " + "x".repeat(500))
                        log.row()
                    }
                    for (i in 1..100) {
                        events.event("event $i!")
                        log.row()
                    }
                    filler.delete()
                    time.pass(RETRY_MILLIS)
                    log.row()
                    log.state shouldBe LogState.LOGGING
                    log.counters().eventsDropped shouldBe 0
                }
            }
            val texts = recordingIn(File(disk, "events.bag")).topics.single().texts.dictionary.joinToString()
            for (i in 1..100) texts shouldContain "event $i!"
        }
    }

    test("events that no row could take before the end are counted").config(enabledOrReasonIf = { IF_FULL }) {
        standardErrorOf {
            val log = BadLog.init("/dev/full")
            val events = BadLog.createEvents("Events")
            log.finishInitialization()
            events.event("one")
            log.row()
            log.close()
            // Including the one that says that nothing can be written.
            log.counters().eventsDropped shouldBe 2
        }
    }

    test("a disk that was full from the start gets the header once it has space").config(enabledOrReasonIf = { ifMount() }) {
        onSmallDisk { disk ->
            val filler = File(disk, "filler")
            fill(filler)
            val time = TestTime()
            standardErrorOf {
                BadLog.init("$disk/late.bag", false, LogSession(flushesEachRow = true, time)).use { log ->
                    createTopics()
                    log.finishInitialization()
                    repeat(10) { log.row() }
                    filler.delete()
                    log.state shouldBe LogState.FAILING
                    // The header is written before any row.
                    time.pass(RETRY_MILLIS)
                    log.state shouldBe LogState.LOGGING
                    repeat(10) { log.row() }
                }
            }
            recordingIn(File(disk, "late.bag")).run {
                rowCount shouldBe 10
                problems.filter { it.severity == Severity.ERROR }.shouldBeEmpty()
            }
        }
    }

    test("a read-only disk is reported, and nothing is logged").config(enabledOrReasonIf = { ifMount() }) {
        onSmallDisk { disk ->
            run(listOf("mount", "-o", "remount,ro", disk.path)).first shouldBe 0
            expectNothingLogged(File(disk, "a.bag"))
        }
    }

    test("a folder that cannot be created is reported, and nothing is logged") {
        inFolder { folder ->
            val file = File(folder, "file").apply { writeText("") }
            expectNothingLogged(File(file, "a.bag"))
            expectNothingLogged(folder)
        }
    }

    test("a file that cannot be written to is reported").config(enabledOrReasonIf = { IF_FULL }) {
        standardErrorOf {
            BadLog.init("/dev/full").use { log ->
                createTopics()
                log.finishInitialization()
                repeat(100) { log.row() }
                log.state shouldBe LogState.FAILING
                log.counters().rowsMissed shouldBe 100
            }
        } shouldContain "/dev/full"
    }

    test("deleting or removing the folder while logging is noticed").config(enabledOrReasonIf = { IF_OPEN_FILES_GO }) {
        val trouble = mapOf<String, (File) -> Unit>(
            "deleted" to { it.deleteRecursively() },
            "renamed" to { it.renameTo(File(it.parentFile, "gone")) },
        )
        for ((name, happen) in trouble) {
            inFolder { folder ->
                val usb = File(folder, name)
                val time = TestTime()
                standardErrorOf {
                    BadLog.init("$usb/logs/a.bag", false, LogSession(flushesEachRow = true, time)).use { log ->
                        createTopics()
                        log.finishInitialization()
                        repeat(10) { log.row() }
                        time.settle()
                        happen(usb)
                        time.pass(LOOK_MILLIS)
                        log.row()
                        log.state shouldBe LogState.LOGGING
                        time.pass(LOOK_MILLIS)
                        log.state shouldBe LogState.FAILING
                        log.row()
                        val counters = log.counters()
                        counters.rowsMissed shouldBe 1
                        counters.rowsWritten shouldBe 11
                    }
                } shouldContain "was deleted, or its disk was removed"
            }
        }
    }

    test("unmounting the disk while logging is noticed").config(enabledOrReasonIf = { ifMount() }) {
        onSmallDisk { disk ->
            val time = TestTime()
            standardErrorOf {
                BadLog.init("$disk/a.bag", false, LogSession(flushesEachRow = true, time)).use { log ->
                    createTopics()
                    log.finishInitialization()
                    log.row()
                    run(listOf("umount", "-l", disk.path)).first shouldBe 0
                    time.pass(2 * LOOK_MILLIS)
                    log.state shouldBe LogState.FAILING
                }
            } shouldContain "was removed"
        }
    }
})

private fun createTopics() {
    var count = 0L
    BadLog.createTopicLong("Count", "ul", { ++count })
    for (i in 1..20) BadLog.createTopicDouble("Topic $i", "ul", { count * 0.37 * i })
    BadLog.createEvents("Events")
}

private fun expectNothingLogged(path: File) {
    standardErrorOf {
        BadLog.init(path.path).use { log ->
            createTopics()
            log.finishInitialization()
            repeat(10) { log.row() }
            log.state shouldBe LogState.FAILING
            log.counters().rowsMissed shouldBe 10
        }
    } shouldContain "The log $path cannot be created"
}

private fun fill(file: File) {
    try {
        file.outputStream().use { while (true) it.write(ByteArray(64)) }
    } catch (_: IOException) {
        // Full.
    }
}

/** Runs [test] in a file system of its own, of half a megabyte. */
private inline fun onSmallDisk(test: (File) -> Unit) = inFolder { folder ->
    val disk = File(folder, "disk").apply { mkdir() }
    run(listOf("mount", "-t", "tmpfs", "-o", "size=512k", "badlog", disk.path)).first shouldBe 0
    try {
        test(disk)
    } finally {
        run(listOf("umount", "-l", disk.path))
    }
}

private fun ifMount(): Enabled = inFolder { folder ->
    val mount = listOf("mount", "-t", "tmpfs", "-o", "size=64k", "badlog", folder.path)
    val mounted = canRun("mount") && run(mount).first == 0
    if (mounted) run(listOf("umount", folder.path))
    if (mounted) Enabled.enabled else Enabled.disabled("this user may not mount a small disk")
}
