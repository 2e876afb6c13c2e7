package badlog.page.header

import badlog.page.embedded.GivenLayout
import badlog.page.formula.Formulas
import badlog.protocol.PageAdditions

/**
 * A problem with an addition of the page; the recording itself is complete.
 *
 * @property message a sentence.
 * @property pointer lines in a fixed-width font that point at the mistake, or null.
 */
internal class AdditionProblem(val message: String, val pointer: String? = null)

/** Returns all problems with [additions], [layout], and the definitions of [formulas]. The additions are null if they cannot be read. */
internal fun additionProblems(formulas: Formulas, additions: PageAdditions?, layout: GivenLayout): List<AdditionProblem> {
    val problems = ArrayList<AdditionProblem>()
    if (additions == null) {
        problems += AdditionProblem("This browser cannot read the findings and calculations in this page; try another one.")
    }
    layout.problem?.let { problems += AdditionProblem(it) }
    for (error in formulas.errors) {
        val kind = if (error.text in formulas.own) "Your formula" else "A formula of this page"
        problems += AdditionProblem("$kind cannot be calculated: ${error.message}", error.pointed().substringAfter('\n'))
    }
    additions?.rulesProblem?.let { problem ->
        problems += AdditionProblem(problem.substringBefore('\n'), problem.substringAfter('\n', "").ifEmpty { null })
    }
    additions?.notesProblem?.let { problems += AdditionProblem(it) }
    for (hook in additions?.hooks.orEmpty()) {
        if (hook.error != null) problems += AdditionProblem("The hook ${hook.name} failed: ${hook.error}")
    }
    return problems
}
