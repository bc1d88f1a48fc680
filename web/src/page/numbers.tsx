// The state of the gimbal in numbers.

import { angleWords, axisNames, axisNumbers, fixed } from "./axes.js";
import { useView } from "./session.js";

const perSecond = 8;

export function Numbers() {
  const view = useView(perSecond);
  return (
    <table class="numbers">
      <caption class="hidden">Angles, speeds and powers of the gimbal</caption>
      <thead>
        <tr>
          <td></td>
          <th scope="col">Camera</th>
          <th scope="col">Target</th>
          <th scope="col">Frame</th>
          <th scope="col">Joint</th>
          <th scope="col">Speed</th>
          <th scope="col">Power</th>
        </tr>
      </thead>
      <tbody>
        {axisNumbers.map((n) => {
          const axis = axisNames[n];
          return (
            <tr key={axis}>
              <th scope="row">
                <i class={`swatch ${axis}`} /> {axis}
              </th>
              <td>{view ? angleWords(axis, view.camera[n]) : "–"}</td>
              <td>{view ? angleWords(axis, view.targets[n]) : "–"}</td>
              <td>{view ? angleWords(axis, view.frame[n]) : "–"}</td>
              <td>{view ? `${fixed(view.joints[n])}°` : "–"}</td>
              <td>{view ? `${fixed(view.speeds[n])}°/s` : "–"}</td>
              <td>{view ? `${fixed(view.power[n] * 100, 0)} %` : "–"}</td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}
