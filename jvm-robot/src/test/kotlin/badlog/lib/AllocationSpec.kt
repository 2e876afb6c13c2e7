package badlog.lib

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.io.File

private const val LOOPS = 10_000

class AllocationSpec : FunSpec({
    for (compress in listOf(false, true)) {
        test("updating and logging 50 numeric topics allocates nothing" + if (compress) ", compressed" else "") {
            inFolder { folder ->
                BadLog.init(File(folder, "test.bag").path, compress, true).use { log ->
                    val values = DoubleArray(50)
                    for (i in 0 until 38) BadLog.createTopicDouble("Queried/$i", "V", { values[i] })
                    BadLog.createTopicLong("Long", "ul", { values[38].toLong() })
                    BadLog.createTopicBoolean("Boolean", "ul", { values[39] > 0.0 })
                    val publishers = List(5) { BadLog.createPublisher("Handle/$it", "V", DataInferMode.LAST) }
                    val names = List(5) { "Published/$it" }
                    for (name in names) BadLog.createTopicSubscriber(name, "V", DataInferMode.DEFAULT)
                    log.finishInitialization()

                    val loop = { row: Int ->
                        for (i in values.indices) values[i] = Math.sin(row * 0.01 * i) * 1000.0
                        for (i in 0 until 5) publishers[i].publish(values[40 + i])
                        for (i in 0 until 5) BadLog.publish(names[i], values[45 + i])
                        log.row()
                    }
                    // Numbers below 128, so that the boxes that Kotlin's function types make are not counted: those are
                    // cached.
                    garbageOf { for (row in 0 until LOOPS) loop(row % 128) } shouldBe 0
                }
            }
        }
    }
})
