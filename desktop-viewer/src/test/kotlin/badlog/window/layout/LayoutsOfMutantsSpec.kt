package badlog.window.layout

import badlog.core.bag.Mutant
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.property.PropertyTesting
import java.io.IOException
import java.nio.file.Files
import kotlin.random.Random

private val MUTANTS = PropertyTesting.defaultIterationCount

private val WHOLE = """
    {"badlog-layout":1,"graphs":[{"title":"Mine","lines":["Arm/Angle","Arm/Current"],"filled":true,"y":{"from":-1.0,"to":1.5}},
    {"title":"Battery","lines":["System/Battery Voltage"],"zero":true,"height":120}],"recording":"match.bag",
    "visible":{"from":1.25,"to":20.0},"compared":{"files":["a.bag"],"alignment":"enabled","offsets":[0.5]},"formulas":["[ a ] = b + 1"]}
""".trimIndent()

class LayoutsOfMutantsSpec : FunSpec({
    test("a damaged layout file is read as a layout, or reported in a sentence") {
        val file = tempdir().toPath().resolve("a.badlog-layout.json")
        val random = Random(15)
        repeat(MUTANTS) {
            Files.write(file, Mutant.of(WHOLE.encodeToByteArray(), random, WHOLE.length).bytes)
            try {
                readLayout(file)
            } catch (_: IOException) {
                // The message names the mistake.
            }
        }
    }
})
