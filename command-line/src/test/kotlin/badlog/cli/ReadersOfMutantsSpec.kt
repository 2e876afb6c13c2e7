package badlog.cli

import badlog.core.bag.Mutant
import badlog.files.inFolder
import badlog.formats.driverstation.STATION_EVENTS
import badlog.formats.driverstation.STATION_LOG
import badlog.rules.RulesException
import badlog.rules.RulesFile
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.property.PropertyTesting
import java.io.ByteArrayOutputStream
import java.util.zip.GZIPOutputStream
import kotlin.io.path.div
import kotlin.io.path.readBytes
import kotlin.random.Random

/** How many damaged files are read: some in each build, more by `./gradlew thoroughTest`. */
private val MUTANTS = PropertyTesting.defaultIterationCount

/** Whatever stands in a file: no stack trace, no exit code but 0 to 3, and an end. */
@Tags("InCheck")
class ReadersOfMutantsSpec : FunSpec({
    fun gzipped(bytes: ByteArray) = ByteArrayOutputStream().also { out -> GZIPOutputStream(out).use { it.write(bytes) } }.toByteArray()

    val bag = (SAMPLES / "practice.bag").readBytes().let { it.copyOf(9000) }
    val csv = (SAMPLES / "elevator-bench.csv").readBytes().let { it.copyOf(4000) }
    val wpilog = wpilogBytes(
        listOf(
            Logged("Speed", "double", "{\"unit\":\"m/s\"}", List(60) { it / 50.0 to it * 1.25 }),
            Logged("Count", "int64", "", List(20) { it / 20.0 to it * 1e6 }),
            Logged("DS:enabled", "boolean", "", listOf(0.1 to false, 0.5 to true)),
            Logged("Mode", "string", "", List(20) { it / 20.0 to "mode ${it % 3}" }),
        ),
    )
    val files = mapOf(
        "log.bag" to bag,
        "log.csv" to csv,
        "log.bag.gz" to gzipped(bag),
        "log.wpilog" to wpilog,
        "log.wpilog.gz" to gzipped(wpilog),
        "log.dslog" to STATION_LOG.bytes + STATION_EVENTS.bytes,
    )

    fun shouldEnd(what: String, vararg arguments: Any) {
        withClue(what) { badlog(*arguments).code.code shouldBeLessThan 4 }
    }

    test("every command ends in order on any damaged log") {
        inFolder { folder ->
            val random = Random(11)
            repeat(MUTANTS) { number ->
                val (name, bytes) = files.entries.elementAt(number % files.size)
                val mutant = Mutant.of(bytes, random, minOf(bytes.size, 1500))
                val log = folder.with(name, mutant.bytes)
                val what = "$number, $name${mutant.damage}"
                when (number / files.size % 4) {
                    0 -> shouldEnd(what, "info", log, "--json")
                    1 -> shouldEnd(what, "recover", log, "-o", folder / "out-$name", "--force")
                    2 -> shouldEnd(what, "find", log, "max(Speed) > 1 && duration(Mode = 'mode 1') > 0", "--no-cache")
                    else -> shouldEnd(what, "report", log, "--no-cache")
                }
            }
        }
    }

    test("a damaged file of rules is read, or reported in one sentence") {
        val rules = RulesFile.BUILT_IN.source.encodeToByteArray()
        inFolder { folder ->
            val log = folder.with("log.bag", BAG)
            val random = Random(12)
            repeat(MUTANTS) { number ->
                val mutant = Mutant.of(rules, random, rules.size)
                try {
                    RulesFile.parse(mutant.bytes.decodeToString())
                } catch (e: RulesException) {
                    e.message.orEmpty().lines().size shouldBeLessThan 10
                }
                if (number % 10 > 0) return@repeat
                shouldEnd("$number${mutant.damage}", "report", log, "--no-cache", "--rules", folder.with("rules.toml", mutant.bytes))
            }
        }
    }

    test("a damaged question is answered, or reported in a sentence") {
        val question = "integral(if(Enabled, Speed, 0)) > 2 && count(changed(Log)) < 3 || max(Speed, 1 s) >= 1:30 and duration(Log contains 'go' for 0.02 s) > 0 s"
        inFolder { folder ->
            val log = folder.with("log.bag", BAG)
            val random = Random(13)
            repeat(MUTANTS) { number ->
                val mutant = Mutant.of(question.encodeToByteArray(), random, question.length)
                shouldEnd("$number${mutant.damage}", "find", "--no-cache", log, "--", mutant.bytes.decodeToString())
            }
        }
    }
})
