package badlog.signals.clock

import badlog.core.recording.Value
import badlog.core.text.wallTimeText
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.PropertyTesting
import kotlin.math.abs
import kotlin.random.Random

/** A match of the day: its start, in s since 1970, and the names of both sides' logs. */
private class Played(val number: Int, val begin: Double, val robot: ClockedLog, val station: ClockedLog)

/** Twelve matches, some of them replayed, with two laptops; one of them is an hour ahead. All have the same periods, as on every field. */
private fun day(random: Random, hasNumbers: Boolean): List<Played> {
    val numbers = (1..12).flatMap { if (random.nextInt(6) == 0) listOf(it, it) else listOf(it) }
    val begins = ArrayList<Double>()
    return numbers.mapIndexed { index, number ->
        var now = (begins.lastOrNull() ?: 1_772_895_845.0) + random.nextInt(420, 700)
        // Without numbers, two matches could not be distinguished that are exactly as far from each other as the laptops' clocks.
        while (begins.any { abs(now - it - 3600) < 20 }) now += 45
        begins += now
        val jitter = List(4) { random.nextDouble(-0.02, 0.02) }
        val periods = listOf(20.0, 35.3, 37.1, 172.2).mapIndexed { i, time -> time + jitter[i] }
        val values = if (hasNumbers) listOf(Value("Match Number", "$number"), Value("Match Type", "Qualification")) else emptyList()
        // The robot is switched on a while before the match, and the Driver Station begins another while before it.
        val (early, before) = random.nextDouble(10.0, 90.0) to random.nextDouble(1.0, 15.0)
        val robot = logOf(listOf(flag("DS:enabled", 0.0, periods.map { it + early }, 200 + early)), wallTimeText((now - early) * 1e6), values)
        val ahead = if (random.nextBoolean()) 3600.0 else 0.0
        val stationBegin = now - before + ahead
        val isKnown = hasNumbers && random.nextBoolean()
        val enabled = flag("Driver Station/Enabled", 0.0, periods.map { it + before + random.nextDouble(-0.02, 0.02) }, 200 + before)
        val station = logOf(listOf(enabled), wallTimeText(stationBegin * 1e6), if (isKnown) values else emptyList())
        Played(number, now, clocked(robot, "robot $index"), clocked(station, "station $index"))
    }
}

class EventDaySpec : FunSpec({
    test("at a day of matches, each log of a robot gets the Driver Station's log of its match, or none, whatever the laptops' clocks say") {
        val random = Random(254)
        var found = 0
        var matches = 0
        repeat(PropertyTesting.defaultIterationCount / 5) { run ->
            val day = day(random, hasNumbers = run % 2 == 0)
            val stations = day.map { it.station }.shuffled(random)
            for ((index, match) in day.withIndex()) {
                val pair = StationSearch(match.robot, { station: ClockedLog -> station.start }, { it }).over(stations)
                matches++
                if (pair == null) continue
                found++
                withClue("run $run, match $index, number ${match.number}") { pair.station.name shouldBe "station $index" }
            }
        }
        withClue("$found of $matches") { (found > matches * 0.97) shouldBe true }
    }
})
