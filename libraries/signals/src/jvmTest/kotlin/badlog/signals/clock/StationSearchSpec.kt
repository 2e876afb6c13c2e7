package badlog.signals.clock

import badlog.core.recording.Value
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe

class StationSearchSpec : FunSpec({
    /** Enabled from 5 to 8 s and from 9 to 15 s of 17, on a clock that began [later]. */
    fun log(later: Double, start: String?, values: List<Value> = emptyList(), name: String = "log", shift: Double = 0.0) = clocked(logOf(listOf(flag("DS:enabled", 0.0, listOf(5 + shift, 8.0, 9.0, 15.0).map { it - later }, 17.0 - later)), start, values), name)

    fun found(robot: ClockedLog, vararg stations: ClockedLog) = StationSearch(robot, { null }, { it: ClockedLog -> it }).over(stations.toList())

    fun number(text: String) = listOf(Value("Match Number", text))

    test("the log of the same time of day is found, aligned by the moments of enabling, with the error") {
        val robot = log(3.0, "2026-03-07 15:04:08 UTC")
        val other = log(0.0, "2026-03-07 14:04:05 UTC", name = "an hour before")
        val found = checkNotNull(found(robot, other, log(0.0, "2026-03-07 15:04:05 UTC", name = "this", shift = 0.04)))
        found.station.name shouldBe "this"
        found.fit.edges shouldBe 4
        found.fit.seconds shouldBe (-3.01 plusOrMinus 1e-9)
        found.fit.error shouldBe (0.03 plusOrMinus 1e-9)
    }

    test("a robot's log that does not show enabled is aligned by the clocks, which are known to the second") {
        val robot = clocked(logOf(listOf(numbers("Arm", listOf(0.0 to 1.0, 10.0 to 2.0))), "2026-03-07 15:04:08 UTC"))
        val fit = checkNotNull(found(robot, log(0.0, "2026-03-07 15:04:05 UTC"))).fit
        listOf(fit.seconds, fit.edges, fit.error) shouldBe listOf(-3.0, 0, 1.0)
    }

    test("the date in the name of a WPILOG is a time of day, in UTC") {
        clocked(logOf(listOf(numbers("Arm", listOf(2.0 to 1.0)))), "FRC_20260307_150405_MILLC_Q42.wpilog").start shouldBe 1772895845.0
        clocked(logOf(listOf(numbers("Arm", listOf(2.0 to 1.0))), "2026-03-07 15:04:05 UTC")).start shouldBe 1772895843.0
        clocked(logOf(listOf(numbers("Arm", listOf(2.0 to 1.0))), "2026-03-07 15:04:05")).start.shouldBeNull()
        clocked(logOf(listOf(numbers("Arm", listOf(2.0 to 1.0)))), "FRC_20261307_150405.wpilog").start.shouldBeNull()
    }

    test("without a time of day, the match decides, and without a match the moments of enabling, if only one log has them") {
        val stations = arrayOf(log(0.0, "2026-03-07 15:04:05 UTC", number("41"), "a"), log(0.0, "2026-03-07 16:04:05 UTC", number("42"), "b"))
        found(log(3.0, null, number("42")), *stations)?.station?.name shouldBe "b"
        found(log(3.0, null), *stations).shouldBeNull()
        val practice = clocked(logOf(listOf(flag("DS:enabled", 0.0, listOf(1.0, 2.0), 9.0)), "2026-03-07 17:04:05 UTC"), "practice")
        found(log(3.0, null), practice, stations[0])?.station?.name shouldBe "a"
    }

    test("a log of another match is never used, whatever its clock shows, and an hour of daylight saving does not matter") {
        val robot = log(3.0, "2026-03-07 15:04:08 UTC", number("17"))
        val wrong = log(0.0, "2026-03-07 15:04:05 UTC", number("11"), "wrong")
        val right = log(0.0, "2026-03-07 16:04:05 UTC", number("17"), "right")
        for (stations in listOf(listOf(wrong, right), listOf(right, wrong))) {
            checkNotNull(found(robot, *stations.toTypedArray())).run {
                station.name shouldBe "right"
                fit.seconds shouldBe (-3.0 plusOrMinus 1e-9)
            }
        }
        found(robot, wrong).shouldBeNull()
        found(log(3.0, "2026-03-07 15:04:08 UTC", listOf(Value("Match Type", "Practice"))), log(0.0, "2026-03-07 15:04:05 UTC", listOf(Value("Match Type", "Qualification")))).shouldBeNull()
    }

    test("without numbers, a log with moments of enabling that agree with its clock is used, then one an hour off") {
        val robot = log(3.0, "2026-03-07 15:04:08 UTC")
        // At its own time of day it covers the robot's log, but was enabled at other moments by that clock.
        val wrong = log(0.0, "2026-03-07 15:02:05 UTC", name = "wrong")
        val right = log(0.0, "2026-03-07 16:04:05 UTC", name = "right")
        for (stations in listOf(listOf(wrong, right), listOf(right, wrong))) found(robot, *stations.toTypedArray())?.station?.name shouldBe "right"
        val other = log(0.0, "2026-03-07 15:06:05 UTC", name = "other")
        found(robot, wrong, other).shouldBeNull()
    }

    test("two laptops at one match are distinguished by their clocks, and either fits") {
        val robot = log(3.0, "2026-03-07 15:04:08 UTC", number("17"))
        val first = log(0.0, "2026-03-07 15:04:05 UTC", number("17"), "first")
        val second = log(0.0, "2026-03-07 14:04:05 UTC", number("17"), "second")
        found(robot, second, first)?.station?.name shouldBe "first"
    }

    test("the match may be in the name of the robot's log alone") {
        val qualification = number("42") + Value("Match Type", "Qualification")
        val stations = arrayOf(log(0.0, "2026-03-07 15:04:05 UTC", number("41"), "a"), log(0.0, "2026-03-07 16:04:05 UTC", qualification, "b"))
        found(log(3.0, null, name = "Q42.wpilog"), *stations)?.station?.name shouldBe "b"
    }

    test("of many logs, only the ones that may be of the same time of day are read") {
        val read = ArrayList<Int>()
        fun search(robot: ClockedLog) = StationSearch(robot, { hour: Int -> hour * 3600.0 }, { hour ->
            read += hour
            log(0.0, "1970-01-01 00:00:00 UTC", name = "$hour")
        })
        search(log(3.0, "2026-03-07 15:04:08 UTC")).over((1..100).toList(), mostRead = 40).shouldBeNull()
        search(log(3.0, null)).over((1..100).toList(), mostRead = 40).shouldBeNull()
        read shouldBe emptyList()
        // Fewer may be of the match, or have the same moments of enabling; here all have those.
        search(log(3.0, null)).over((1..10).toList(), mostRead = 40).shouldBeNull()
        read shouldBe (1..10).toList()
    }

    test("a single moment of enabling that contradicts the clocks is not trusted") {
        val robot = clocked(logOf(listOf(flag("DS:enabled", 0.0, listOf(5.0), 17.0)), "2026-03-07 15:04:05 UTC"))
        val station = clocked(logOf(listOf(flag("DS:enabled", 0.0, listOf(300.0), 600.0)), "2026-03-07 15:00:05 UTC"))
        checkNotNull(found(robot, station)).fit.run { listOf(seconds, edges) } shouldBe listOf(-240.0, 0)
    }

    test("a robot's log over row numbers has no clock, so no Driver Station's log fits it") {
        val bag = badlog.core.bag.BagParser().apply { accept("A,B\n1,2\n2,3\n".encodeToByteArray()) }.finish()
        found(clocked(bag), log(0.0, null)).shouldBeNull()
    }
})
