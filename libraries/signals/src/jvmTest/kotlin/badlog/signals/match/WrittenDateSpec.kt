package badlog.signals.match

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.long
import io.kotest.property.checkAll
import java.text.SimpleDateFormat
import java.time.Instant
import java.time.ZoneId
import java.time.ZoneOffset
import java.time.ZonedDateTime
import java.time.format.DateTimeFormatter
import java.util.Date
import java.util.Locale
import java.util.TimeZone

private val ZONES = ZoneId.getAvailableZoneIds().sorted()

/** As `Date.toString` prints, in any zone. */
private fun javaDate(second: Long, zone: ZoneId): String = SimpleDateFormat("EEE MMM dd HH:mm:ss zzz yyyy", Locale.US).apply { timeZone = TimeZone.getTimeZone(zone) }.format(Date(second * 1000))

private val GMT = Regex(" GMT([+-]\\d\\d:\\d\\d)? ")

/** A time from 2000 to 2100. */
private val seconds = Arb.long(946_684_800L..4_102_444_799L)

class WrittenDateSpec : FunSpec({
    test("a moment with its offset is read as such, in every zone, as ISO 8601 and RFC 1123 print it") {
        checkAll(seconds, Arb.element(ZONES)) { second, zone ->
            val time = ZonedDateTime.ofInstant(Instant.ofEpochSecond(second), ZoneId.of(zone))
            val texts = listOf(
                DateTimeFormatter.RFC_1123_DATE_TIME.format(time),
                DateTimeFormatter.ISO_OFFSET_DATE_TIME.format(time),
                DateTimeFormatter.ISO_ZONED_DATE_TIME.format(time),
                DateTimeFormatter.ofPattern("EEE, d MMM yyyy HH:mm:ss Z", Locale.US).format(time),
                time.toString(),
                time.toInstant().toString(),
            )
            for (text in texts) withClue(text) { dateInText(text) shouldBe localSecondOf(second) }
        }
    }

    test("a time without an offset is a time on a clock on the wall") {
        checkAll(seconds) { second ->
            val time = ZonedDateTime.ofInstant(Instant.ofEpochSecond(second), ZoneId.of("UTC")).toLocalDateTime()
            val patterns = listOf("MMM d, yyyy, h:mm:ss a", "M/d/yyyy h:mm:ss a", "MM/dd/yyyy HH:mm:ss", "EEE MMM d HH:mm:ss yyyy", "d MMM yyyy HH:mm:ss")
            for (text in patterns.map { DateTimeFormatter.ofPattern(it, Locale.US).format(time) } + DateTimeFormatter.ISO_LOCAL_DATE_TIME.format(time)) {
                withClue(text) { dateInText(text) shouldBe second }
            }
        }
    }

    test("Java's Date is a moment if the name of its zone is clear, otherwise the local time") {
        checkAll(seconds, Arb.element(ZONES)) { second, name ->
            val zone = ZoneId.of(name)
            val there = second + zone.rules.getOffset(Instant.ofEpochSecond(second)).totalSeconds
            val text = javaDate(second, zone)
            withClue(text) {
                val date = checkNotNull(writtenDate(text))
                date.second shouldBe there
                if (name == "America/New_York" || name == "UTC") date.utcSecond shouldBe second
                // Java prints a zone's offset of today even beside a clock of its past, as in Punta Arenas in 2002.
                GMT.find(text)?.let { date.utcSecond shouldBe there - ZoneOffset.of(it.groupValues[1].ifEmpty { "Z" }).totalSeconds }
            }
        }
        for (name in listOf("America/New_York", "America/Denver", "America/Los_Angeles", "Europe/Berlin")) {
            val zone = ZoneId.of(name)
            for (second in listOf(1_516_000_000L, 1_531_000_000L)) dateInText(javaDate(second, zone)) shouldBe localSecondOf(second)
        }
    }

    test("a date in CST, a zone of America and of Asia, is a time on a clock on the wall") {
        for (zone in listOf("America/Chicago", "Asia/Shanghai", "Asia/Taipei")) {
            val time = ZonedDateTime.ofInstant(Instant.ofEpochSecond(1_516_000_000L), ZoneId.of(zone))
            val text = javaDate(time.toEpochSecond(), time.zone)
            withClue(text) {
                text shouldContain " CST "
                writtenDate(text)?.utcSecond shouldBe null
                dateInText(text) shouldBe time.toLocalDateTime().toEpochSecond(ZoneOffset.UTC)
            }
        }
    }

    test("the white paper's team wrote this") {
        dateInText("Fri, 16 Mar 2018 10:41:07 -0400") shouldBe localSecondOf(1_521_211_267L)
    }
})
