package badlog.window.panel

import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.text.selection.SelectionContainer
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.graphics.vector.ImageVector
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.panel.Button
import badlog.viewer.panel.Buttons
import badlog.viewer.panel.Card
import badlog.viewer.panel.Cards
import badlog.viewer.panel.Choice
import badlog.viewer.panel.Code
import badlog.viewer.panel.Field
import badlog.viewer.panel.Fold
import badlog.viewer.panel.Heading
import badlog.viewer.panel.Offers
import badlog.viewer.panel.Paragraph
import badlog.viewer.panel.Part
import badlog.viewer.panel.PartIcon
import badlog.viewer.panel.Picture
import badlog.viewer.panel.Rows
import badlog.viewer.panel.Table
import badlog.viewer.panel.Tone
import badlog.viewer.panel.Trouble
import badlog.viewer.panel.Value
import badlog.viewer.state.Action
import badlog.window.findings.findingColor
import badlog.window.pen.pen
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.Tip
import badlog.window.theme.ToolButton
import badlog.viewer.panel.Row as PanelRow

/** Shows [part]. A fold shows only its title, because its content consists of further parts. */
@Composable
internal fun PartView(part: Part, send: (Action) -> Unit, modifier: Modifier = Modifier) {
    when (part) {
        is Heading -> HeadingView(part, send)
        is Paragraph -> ParagraphView(part, send)
        is Trouble -> TroubleView(part)
        is Buttons -> FlowRow(Modifier.padding(horizontal = 12.dp), Arrangement.spacedBy(2.dp)) { ButtonsView(part.buttons, send) }
        is Offers -> OffersView(part, send)
        is Choice -> ChoiceView(part, send, modifier)
        is Code -> CodeView(part)
        is Field -> FieldView(part, send)
        is Fold -> FoldTitle(part, send)
        is Rows -> for (row in part.rows) PartView(row, send)
        is PanelRow -> RowView(part, send)
        is Value -> ValueView(part, send)
        is Cards -> CardsView(part, send)
        is Card -> CardView(part, send, modifier)
        is Table -> TableView(part, send)
        is Picture -> PictureView(part)
    }
}

@Composable
private fun HeadingView(heading: Heading, send: (Action) -> Unit) {
    Row(Modifier.fillMaxWidth().padding(start = 12.dp, end = 4.dp, top = 4.dp), verticalAlignment = Alignment.CenterVertically) {
        // The tab above has the title.
        Text(heading.status, Modifier.weight(1f), fontWeight = FontWeight.Medium)
        ButtonsView(heading.tools, send, areIcons = true)
    }
}

@Composable
private fun ParagraphView(paragraph: Paragraph, send: (Action) -> Unit) {
    Row(Modifier.fillMaxWidth().padding(horizontal = 12.dp, vertical = 2.dp), verticalAlignment = Alignment.CenterVertically) {
        ToneText(paragraph, Modifier.weight(1f))
        paragraph.button?.let { ButtonsView(listOf(it), send) }
    }
}

/** The text of [paragraph], without its button, in the color of its tone. */
@Composable
internal fun ToneText(paragraph: Paragraph, modifier: Modifier = Modifier) {
    val palette = LocalPalette.current
    val color = when (paragraph.tone) {
        Tone.BODY, Tone.TITLE -> palette.text
        Tone.MUTED -> palette.muted
        Tone.ALERT -> palette.error
    }
    val isLarge = paragraph.tone == Tone.TITLE
    Text(paragraph.text, modifier, color, fontSize = if (isLarge) 20.sp else 12.sp, fontWeight = FontWeight.SemiBold.takeIf { isLarge })
}

/** Shows [buttons]; with [areIcons], it shows only their icons. */
@Composable
internal fun ButtonsView(buttons: List<Button>, send: (Action) -> Unit, areIcons: Boolean = false) {
    for (button in buttons) {
        val text = button.label.takeIf { !areIcons }
        ToolButton(button.hint, button.icon?.vector, text, button.isOn, button.isEnabled) { send(button.action) }
    }
}

/** The icon in the window. */
internal val PartIcon.vector: ImageVector
    get() = when (this) {
        PartIcon.PREVIOUS -> Icons.Up
        PartIcon.NEXT -> Icons.Down
        PartIcon.AGAIN -> Icons.Reset
        PartIcon.PIN -> Icons.Pin
        PartIcon.ADD -> Icons.Add
        PartIcon.REMOVE -> Icons.Remove
        PartIcon.NOTE -> Icons.Note
        PartIcon.ZOOM -> Icons.Search
        PartIcon.CLOSE -> Icons.Close
        PartIcon.DONE -> Icons.Check
        PartIcon.PERSON -> Icons.Flag
        PartIcon.UNDONE -> Icons.Undo
        PartIcon.HISTOGRAM -> Icons.Chart
    }

@Composable
private fun OffersView(offers: Offers, send: (Action) -> Unit) {
    Column(
        Modifier
            .fillMaxWidth()
            .padding(horizontal = 8.dp, vertical = 4.dp)
            .background(LocalPalette.current.accentSoft, RoundedCornerShape(4.dp))
            .padding(horizontal = 6.dp, vertical = 4.dp)
            .semantics { contentDescription = offers.title },
    ) {
        Text(offers.title, fontWeight = FontWeight.Medium)
        for (button in offers.buttons) {
            Tip(button.hint) {
                Text(button.label, Modifier.fillMaxWidth().clickable(role = Role.Button) { send(button.action) }.padding(vertical = 2.dp))
            }
        }
    }
}

@Composable
private fun FoldTitle(fold: Fold, send: (Action) -> Unit) {
    val palette = LocalPalette.current
    Row(
        Modifier
            .fillMaxWidth()
            .clickable(role = Role.Button) { send(fold.toggle) }
            .semantics { stateDescription = if (fold.isOpen) "expanded" else "collapsed" }
            .padding(start = 8.dp, end = 14.dp, top = 8.dp, bottom = 4.dp),
        Arrangement.spacedBy(4.dp),
        Alignment.CenterVertically,
    ) {
        Icon(if (fold.isOpen) Icons.Down else Icons.Right, contentDescription = null, Modifier.size(14.dp), palette.muted)
        Text(fold.title, color = fold.severity?.let(palette::findingColor) ?: palette.muted)
    }
}

@Composable
private fun ChoiceView(choice: Choice, send: (Action) -> Unit, modifier: Modifier) {
    FlowRow(
        modifier.fillMaxWidth().padding(horizontal = 22.dp),
        Arrangement.spacedBy(2.dp),
        itemVerticalAlignment = Alignment.CenterVertically,
    ) {
        Text(choice.name, color = LocalPalette.current.muted)
        for (option in choice.options) {
            val hint = if (option.hint == option.label) "${choice.name} ${option.label}" else option.hint
            ToolButton(hint, text = option.label, isOn = option.isOn == true) { send(option.action) }
        }
    }
}

@Composable
private fun CodeView(code: Code) {
    SelectionContainer(Modifier.padding(start = 22.dp, end = 14.dp, top = 2.dp, bottom = 6.dp)) {
        Text(
            code.text,
            Modifier
                .fillMaxWidth()
                .background(LocalPalette.current.raised, RoundedCornerShape(4.dp))
                .horizontalScroll(rememberScrollState())
                .padding(horizontal = 8.dp, vertical = 4.dp),
            fontFamily = FontFamily.Monospace,
            fontSize = 12.sp,
            softWrap = false,
        )
    }
}

@Composable
private fun PictureView(picture: Picture) {
    val colors = LocalPalette.current.pen
    Spacer(
        Modifier.fillMaxWidth().height(picture.height.dp).semantics { contentDescription = picture.name }.drawBehind {
            picture.draw(pen(), size.width.toDouble(), colors)
        },
    )
}
