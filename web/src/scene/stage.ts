// The stage: renderer, camera and controls. A frame is drawn only when something changes. If frames take long, they have
// less detail until nothing changes for a moment.

import { Group, MOUSE, PerspectiveCamera, Raycaster, Scene, Sphere, Vector2, Vector3, WebGLRenderer, type Ray } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { Pixel } from '../geometry/nearness';
import { atRest, Pace, type Detail } from '../view/pace';

const rest = 160; // ms without a change
const restHeld = 600; // the same while a button is pressed, as in a drag

export class Stage {
  readonly scene = new Scene();
  /// Objects in the project's coordinates, with vertical exaggeration.
  readonly world = new Group();
  readonly camera = new PerspectiveCamera(32, 1, 0.1, 1000);
  readonly renderer: WebGLRenderer;
  readonly controls: OrbitControls;
  /// A sphere around the model, in the scene's coordinates without exaggeration.
  readonly extent = new Sphere(new Vector3(), 100);
  /// Called before each frame; true requests another frame.
  readonly beforeFrame: (() => boolean | void)[] = [];
  /// Called after each frame.
  readonly afterFrame: (() => void)[] = [];
  /// The point of the picture at which the camera looks [CSS pixels]; null: the centre.
  private aim: Pixel | null = null;
  onLost: (lost: boolean) => void = () => {};
  onResize: () => void = () => {};
  private frame = 0;
  private readonly pace = new Pace();
  /// What the frame that is being drawn has, and whether the view moves.
  detail: Detail = atRest;
  isMoving = false;
  private isHeld = false;
  private readonly listening = new AbortController();
  private resting: ReturnType<typeof setTimeout> | undefined;
  private timing: ReturnType<typeof setTimeout> | undefined;
  private readonly watcher: ResizeObserver;

  /// Throws if the browser has no WebGL 2.
  constructor(readonly host: HTMLElement) {
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true, powerPreference: 'high-performance' });
    this.renderer.setPixelRatio(this.fullRatio);
    const { domElement: canvas } = this.renderer;
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'application');
    canvas.setAttribute(
      'aria-label',
      'Model in three dimensions. Arrow keys move the view, with Shift they rotate it, plus and minus zoom, 1 to 8 choose a named view.',
    );
    host.append(canvas);
    this.scene.add(this.world);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.18;
    this.controls.screenSpacePanning = false;
    this.controls.maxPolarAngle = Math.PI * 0.98;
    this.controls.mouseButtons = { LEFT: MOUSE.ROTATE, MIDDLE: MOUSE.DOLLY, RIGHT: MOUSE.PAN };
    this.controls.keyPanSpeed = 40;
    this.controls.listenToKeyEvents(canvas);
    this.controls.addEventListener('change', () => this.invalidate());
    canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      this.onLost(true);
    });
    canvas.addEventListener('webglcontextrestored', () => {
      this.onLost(false);
      this.invalidate();
    });
    const { signal } = this.listening;
    host.addEventListener('pointerdown', () => (this.isHeld = true), { capture: true, signal });
    for (const end of ['pointerup', 'pointercancel']) addEventListener(end, () => (this.isHeld = false), { capture: true, signal });
    this.watcher = new ResizeObserver(() => this.resize());
    this.watcher.observe(host);
    this.resize();
  }

  /// The size while rendering for print; null otherwise.
  private paper: { width: number; height: number } | null = null;

  get size(): { width: number; height: number } {
    return this.paper ?? this.hostSize;
  }

  private get hostSize(): { width: number; height: number } {
    return { width: Math.max(1, this.host.clientWidth), height: Math.max(1, this.host.clientHeight) };
  }

  private get fullRatio(): number {
    return Math.min(devicePixelRatio, 2);
  }

  private resize() {
    const { width, height } = this.size;
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.aimAt(this.aim);
    this.onResize();
    this.draw();
  }

  /// Moves the target of the camera to a point of the picture, such as the centre of its free part.
  aimAt(place: Pixel | null) {
    this.aim = place;
    const { width, height } = this.size;
    if (place) this.camera.setViewOffset(width, height, width / 2 - place[0], height / 2 - place[1], width, height);
    else this.camera.clearViewOffset();
    this.camera.updateProjectionMatrix();
  }

  /// Multiplies the distance of the camera.
  dolly(factor: number) {
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
  }

  /// Runs a task as if the picture had another size.
  inSize<T>(size: { width: number; height: number }, task: () => T): T {
    const { camera, controls, aim } = this;
    const [eye, target] = [camera.position.clone(), controls.target.clone()];
    this.paper = size;
    try {
      camera.aspect = size.width / size.height;
      this.aimAt(null);
      return task();
    } finally {
      this.paper = null;
      camera.position.copy(eye);
      controls.target.copy(target);
      camera.aspect = this.size.width / this.size.height;
      this.aimAt(aim);
      controls.update();
    }
  }

  /// Renders at the current size with `ratio` pixels per CSS pixel, and returns a copy.
  copy(ratio: number): HTMLCanvasElement {
    const { width, height } = this.size;
    const made = document.createElement('canvas');
    try {
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(width, height, false);
      this.render(null);
      Object.assign(made, { width: Math.round(width * ratio), height: Math.round(height * ratio) });
      made.getContext('2d', { willReadFrequently: true })!.drawImage(this.renderer.domElement, 0, 0, made.width, made.height);
    } finally {
      this.renderer.setPixelRatio(this.fullRatio);
      this.renderer.setSize(this.hostSize.width, this.hostSize.height);
    }
    return made;
  }

  invalidate() {
    this.frame ||= requestAnimationFrame(this.next);
  }

  private readonly next = () => {
    this.frame = 0;
    this.frameOf(this.pace.moving);
  };

  /// Draws a frame with all detail at once. The pixels can only be read in the same task.
  draw() {
    this.frameOf(null);
  }

  /// `moving`: the detail of a moving view.
  private frameOf(moving: Detail | null) {
    clearTimeout(this.resting);
    const ratio = this.fullRatio * (moving ?? atRest).pixels;
    if (this.renderer.getPixelRatio() !== ratio) this.renderer.setPixelRatio(ratio);
    this.render(moving);
    this.time(moving !== null);
    if (moving) this.resting = setTimeout(this.settle, this.isHeld ? restHeld : rest);
    // For tests, and for those who wonder.
    this.renderer.domElement.dataset.detail = moving ? 'less' : 'all';
  }

  private readonly settle = () => {
    if (this.frame === 0) this.draw();
  };

  private render(moving: Detail | null) {
    this.detail = moving ?? atRest;
    this.isMoving = moving !== null;
    let needsMore = this.controls.update();
    this.clip();
    this.camera.updateMatrixWorld();
    for (const task of this.beforeFrame) needsMore = task() === true || needsMore;
    this.renderer.render(this.scene, this.camera);
    for (const task of this.afterFrame) task();
    if (needsMore) this.invalidate();
  }

  /// Measures how long the graphics take for the frame.
  private time(isMoving: boolean) {
    if (this.timing !== undefined) return; // an earlier frame is not finished
    const gl = this.renderer.getContext() as WebGL2RenderingContext;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!fence) return;
    const begun = performance.now();
    const look = () => {
      this.timing = undefined;
      if (gl.isContextLost()) return;
      if (gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) return void (this.timing = setTimeout(look, 4));
      gl.deleteSync(fence);
      const took = performance.now() - begun;
      if (isMoving) this.pace.movingTook(took);
      else this.pace.restTook(took);
    };
    this.timing = setTimeout(look, 0);
  }

  private readonly centre = new Vector3();
  private clip() {
    const centre = this.centre.copy(this.extent.center);
    const stretch = this.world.scale.z;
    centre.z *= stretch;
    const radius = this.extent.radius * Math.max(1, stretch);
    const away = this.camera.position.distanceTo(centre);
    const { camera } = this;
    camera.near = Math.max(away - 1.5 * radius, 0.01 * this.camera.position.distanceTo(this.controls.target), 1e-3);
    camera.far = Math.max(away + 1.5 * radius, 2 * camera.near);
    camera.updateProjectionMatrix();
  }

  /// Metres per pixel at the centre of rotation.
  get metresPerPixel(): number {
    const distance = this.camera.position.distanceTo(this.controls.target);
    return (2 * distance * Math.tan((this.camera.fov * Math.PI) / 360)) / this.size.height;
  }

  /// The ray through a point of the window, in the scene's coordinates without exaggeration. Its direction does not have
  /// unit length.
  ray(clientX: number, clientY: number): Ray {
    const box = this.renderer.domElement.getBoundingClientRect();
    const at = new Vector2(
      ((clientX - box.left) / box.width) * 2 - 1,
      1 - ((clientY - box.top) / box.height) * 2,
    );
    const caster = new Raycaster();
    caster.setFromCamera(at, this.camera);
    caster.ray.origin.z /= this.world.scale.z;
    caster.ray.direction.z /= this.world.scale.z;
    return caster.ray;
  }

  /// The CSS pixel of a point of the world; null behind the camera.
  pixelOf(point: Vector3): { x: number; y: number } | null {
    const { width, height } = this.size;
    const at = point.clone().applyMatrix4(this.world.matrixWorld).project(this.camera);
    return at.z > 1 ? null : { x: ((at.x + 1) / 2) * width, y: ((1 - at.y) / 2) * height };
  }

  dispose() {
    cancelAnimationFrame(this.frame);
    this.frame = -1;
    clearTimeout(this.resting);
    clearTimeout(this.timing);
    this.listening.abort();
    this.watcher.disconnect();
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.renderer.domElement.remove();
  }
}
